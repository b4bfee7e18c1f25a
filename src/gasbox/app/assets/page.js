// Keys, dropped files and visibility of the page: what only the browser knows, told to the server as events.
(() => {
  "use strict";
  const settings = window.gasboxPage; // {keys: [...], holds: {key: name}, upload: id}, written by page.py

  const typing = (target) =>
    target instanceof HTMLElement &&
    (target.isContentEditable || /^(INPUT|TEXTAREA|SELECT)$/.test(target.tagName) || target.closest(".q-menu"));
  const pressable = (target) =>
    target instanceof HTMLElement && target.closest("button, a, [role=button], [role=switch], [role=checkbox], [role=radio]");
  const sliding = (target) => target instanceof HTMLElement && target.closest("[role=slider]");
  const covered = () => document.querySelector(".q-dialog:not(.q-dialog--seamless) .q-dialog__inner") !== null;

  document.addEventListener("keydown", (event) => {
    const { key, target } = event;
    if (event.ctrlKey || event.metaKey || event.altKey || !settings.keys.includes(key)) return;
    if (typing(target) || covered()) return;
    if (key === " " && (pressable(target) || event.repeat)) return;
    if (key.startsWith("Arrow") && sliding(target)) return;
    event.preventDefault();
    emitEvent("gasbox_key", key);
  });

  // What acts for as long as a key or a button (data-hold) is down. One at a time; whatever takes the attention away ends it.
  let held = null;
  const hold = (name, by) => {
    if (held !== null) return;
    held = by;
    emitEvent("gasbox_hold", name);
  };
  const letGo = () => {
    if (held === null) return;
    held = null;
    emitEvent("gasbox_hold", "");
  };
  const holder = (target) => (target instanceof Element ? target.closest("[data-hold]") : null);
  const presses = (key) => key === " " || key === "Enter";
  // On the way down, because buttons keep what is pressed on them to themselves.
  document.addEventListener(
    "keydown",
    (event) => {
      const { key, target } = event;
      if (event.ctrlKey || event.metaKey || event.altKey || event.repeat) return;
      const button = holder(target);
      if (button && presses(key)) hold(button.dataset.hold, key);
      else if (key in settings.holds && !typing(target) && !covered()) hold(settings.holds[key], key);
    },
    true,
  );
  document.addEventListener(
    "keyup",
    ({ key }) => {
      if (typeof held === "string" && key.toLowerCase() === held.toLowerCase()) letGo();
    },
    true,
  );
  document.addEventListener("pointerdown", (event) => {
    const button = holder(event.target);
    if (!button || event.button !== 0) return;
    hold(button.dataset.hold, event.pointerId);
  });
  for (const end of ["pointerup", "pointercancel"]) {
    window.addEventListener(end, ({ pointerId }) => held === pointerId && letGo());
  }
  window.addEventListener("blur", letGo);
  document.addEventListener("visibilitychange", letGo);
  document.addEventListener("contextmenu", (event) => holder(event.target) && event.preventDefault());

  // After a click with the mouse the focus leaves the control, so that Space still means play or pause.
  document.addEventListener("click", (event) => {
    const focused = document.activeElement;
    if (event.detail > 0 && focused instanceof HTMLElement && focused.closest(".lab-bar, .lab") && !typing(focused)) {
      focused.blur();
    }
  });

  let depth = 0;
  const carriesFile = (event) => event.dataTransfer && Array.from(event.dataTransfer.types).includes("Files");
  const shade = () => document.body.classList.toggle("file-over", depth > 0);
  window.addEventListener("dragenter", (event) => {
    if (!carriesFile(event)) return;
    depth += 1;
    shade();
  });
  window.addEventListener("dragleave", (event) => {
    if (!carriesFile(event)) return;
    depth = Math.max(0, depth - 1);
    shade();
  });
  window.addEventListener("dragover", (event) => {
    if (carriesFile(event)) event.preventDefault();
  });
  window.addEventListener("drop", (event) => {
    if (!carriesFile(event)) return;
    event.preventDefault();
    depth = 0;
    shade();
    const files = Array.from(event.dataTransfer.files).slice(0, 1);
    if (files.length) getElement(settings.upload).$refs.qRef.addFiles(files);
  });

  // A hidden page asks for no charts and no numbers.
  const tellVisible = () => window.did_handshake && emitEvent("gasbox_visible", document.visibilityState === "visible");
  document.addEventListener("visibilitychange", tellVisible);
})();
