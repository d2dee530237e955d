//! Rays that leave a surface neither hit it again nor pass through it, at any scale.
