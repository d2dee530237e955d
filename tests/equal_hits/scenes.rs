//! Two levels: objects of every form, under every kind of transform, and the pictures of scenes.
