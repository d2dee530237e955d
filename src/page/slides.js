// Shows one slide at a time. Without this script all of them stand in rows.
(() => {
  const controls = document.querySelector(".controls");
  const slides = [...document.querySelectorAll(".slides figure")];
  if (!controls || slides.length < 2) return;
  const range = controls.querySelector("input");
  const all = controls.querySelector("[data-all]");
  const play = controls.querySelector("[data-play]");
  const show = (place) => {
    range.value = Math.min(Math.max(place, 0), slides.length - 1);
    slides.forEach((slide, i) => slide.classList.toggle("current", i === Number(range.value)));
    range.setAttribute("aria-valuetext", slides[range.value].querySelector("strong").textContent);
  };
  const showAll = (whether) => {
    document.body.classList.toggle("one", !whether);
    all.setAttribute("aria-pressed", String(whether));
    range.disabled = whether;
  };
  let timer;
  const stop = () => {
    clearInterval(timer);
    timer = undefined;
    play?.setAttribute("aria-pressed", "false");
  };
  range.addEventListener("input", () => {
    stop();
    show(Number(range.value));
  });
  for (const button of controls.querySelectorAll("[data-step]")) {
    button.addEventListener("click", () => {
      stop();
      showAll(false);
      show(Number(range.value) + Number(button.dataset.step));
    });
  }
  all.addEventListener("click", () => {
    stop();
    showAll(all.getAttribute("aria-pressed") !== "true");
  });
  play?.addEventListener("click", () => {
    if (timer) return stop();
    showAll(false);
    play.setAttribute("aria-pressed", "true");
    // Behind the last comes the first.
    timer = setInterval(() => show((Number(range.value) + 1) % slides.length), Number(play.dataset.play));
  });
  document.addEventListener("keydown", (event) => {
    if (event.target === range || event.altKey || event.ctrlKey || event.metaKey) return;
    const step = { ArrowRight: 1, PageDown: 1, ArrowLeft: -1, PageUp: -1 }[event.key];
    if (!step || !document.body.classList.contains("one")) return;
    event.preventDefault();
    stop();
    show(Number(range.value) + step);
  });
  controls.hidden = false;
  show(0);
  showAll(false);
})();
