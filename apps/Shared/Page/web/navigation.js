// Turning, zooming and moving the view by mouse, touch and pen, and clicks in it.

const clickDistance = 4;

function middleOf(pointers) {
  const all = [...pointers.values()];
  const mean = (of) => all.reduce((sum, pointer) => sum + of(pointer), 0) / all.length;
  return { x: mean((p) => p.x), y: mean((p) => p.y) };
}

function spreadOf(pointers) {
  const [a, b] = [...pointers.values()];
  return b ? Math.hypot(a.x - b.x, a.y - b.y) : 0;
}

/** \param onClick is called with pixels from the element's upper left, and whether it is the second of two. */
export function navigate(element, scene, onClick) {
  const pointers = new Map();
  let travelled = 0;
  const drag = (event) => {
    const before = { ...middleOf(pointers), spread: spreadOf(pointers) };
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    const after = { ...middleOf(pointers), spread: spreadOf(pointers) };
    const [x, y] = [after.x - before.x, after.y - before.y];
    travelled += Math.hypot(x, y) + Math.abs(after.spread - before.spread);
    if (travelled < clickDistance) {
      return;
    }
    element.classList.add('turning');
    if (pointers.size > 1) {
      scene.moveCamera(before.spread / Math.max(after.spread, 1));
    }
    if (pointers.size > 1 || event.shiftKey || event.buttons & 6) {
      scene.shiftCamera(x, y);
    } else {
      scene.turnCamera((x * 240) / element.clientHeight, (y * 240) / element.clientHeight);
    }
  };
  const release = (event) => {
    const wasThere = pointers.delete(event.pointerId);
    element.classList.remove('turning');
    if (wasThere && event.type === 'pointerup' && pointers.size === 0 && travelled < clickDistance && event.button === 0) {
      const box = element.getBoundingClientRect();
      onClick(event.clientX - box.left, event.clientY - box.top);
    }
  };
  element.addEventListener('pointerdown', (event) => {
    travelled = pointers.size > 0 ? clickDistance : 0;
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    element.setPointerCapture(event.pointerId);
    element.focus({ preventScroll: true });
  });
  element.addEventListener('pointermove', (event) => pointers.has(event.pointerId) && drag(event));
  element.addEventListener('pointerup', release);
  element.addEventListener('pointercancel', release);
  element.addEventListener('contextmenu', (event) => event.preventDefault());
  element.addEventListener('wheel', (event) => {
    event.preventDefault();
    const lines = event.deltaMode === 0 ? event.deltaY / 100 : event.deltaY / 3;
    scene.moveCamera(1.12 ** Math.max(-4, Math.min(4, lines)));
  }, { passive: false });
}

/** Calls the action of a key that is pressed while the element has the focus. */
export function listenToKeys(element, actions) {
  element.addEventListener('keydown', (event) => {
    const name = (event.shiftKey && event.key.startsWith('Arrow') ? 'Shift' : '') + event.key;
    const action = event.ctrlKey || event.metaKey || event.altKey ? undefined : actions[name];
    if (action) {
      event.preventDefault();
      action();
    }
  });
}
