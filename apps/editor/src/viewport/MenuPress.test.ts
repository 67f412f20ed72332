import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { Selection } from '../model/Selection';
import { MenuPress } from './MenuPress';
import type { Viewport } from './Viewport';

const AT = { clientX: 100, clientY: 50 };
const finger = { pointerType: 'touch', pointerId: 1, button: 0, isPrimary: true, ...AT };
const mouse = { pointerType: 'mouse', pointerId: 9, button: 2, isPrimary: true, ...AT };

describe('MenuPress', () => {
  const open = vi.fn<(x: number, y: number) => void>();
  const stopped = vi.fn<(what: string) => void>();
  const canvas = new EventTarget();
  const selection = new Selection();
  const state = { seen: 'a' as string | null, isHot: false, isDragging: false, flew: false, sceneListens: false };
  const viewport = {
    canvas,
    document: { selection },
    get sceneListens() {
      return state.sceneListens;
    },
    gizmo: state,
    editorCamera: {
      fly: state,
      set enabled(enabled: boolean) {
        stopped(`camera ${enabled}`);
      },
    },
    picker: {
      objectAt: (x: number, y: number) =>
        state.seen === null || x !== AT.clientX || y !== AT.clientY ? null : { id: state.seen },
      cancel: () => stopped('click'),
    },
    boxSelect: { cancel: () => stopped('box') },
  };
  const send = (type: string, event: object): boolean =>
    canvas.dispatchEvent(Object.assign(new Event(`pointer${type}`), event));
  let press: MenuPress;

  beforeEach(() => {
    vi.useFakeTimers();
    press = new MenuPress(viewport as unknown as Viewport, open);
  });
  afterEach(() => {
    press.dispose();
    vi.useRealTimers();
    vi.clearAllMocks();
    selection.clear();
    Object.assign(state, { seen: 'a', isHot: false, isDragging: false, flew: false, sceneListens: false });
  });

  it('opens where a finger rests, selects what is there, and ends all else that the finger could do', () => {
    send('down', finger);
    send('move', { ...finger, clientX: 106, clientY: 55 });
    vi.advanceTimersByTime(499);
    expect(open).not.toHaveBeenCalled();
    vi.advanceTimersByTime(1);
    expect(open.mock.calls).toEqual([[100, 50]]);
    expect(selection.ids).toEqual(['a']);
    expect(stopped.mock.calls.flat()).toEqual(['click', 'box', 'camera false', 'camera true']);
    send('up', finger);
    vi.advanceTimersByTime(1000);
    expect(open).toHaveBeenCalledTimes(1);
  });

  it('opens where the right button is clicked', () => {
    send('down', mouse);
    send('move', { ...mouse, clientX: 102 });
    vi.advanceTimersByTime(3000);
    expect(open).not.toHaveBeenCalled();
    send('up', mouse);
    expect(open.mock.calls).toEqual([[100, 50]]);
    expect(stopped).not.toHaveBeenCalled();
  });

  it('keeps a selection that what is there belongs to, and clears it over nothing', () => {
    const click = (): void => {
      send('down', mouse);
      send('up', mouse);
    };
    selection.set(['b', 'a']);
    click();
    expect(selection.ids).toEqual(['b', 'a']);
    state.seen = null;
    click();
    expect(selection.ids).toEqual([]);
    expect(open).toHaveBeenCalledTimes(2);
  });

  it.each<[string, () => void]>([
    ['a finger that moved by more than 8 pixels', () => send('move', { ...finger, clientX: 109 })],
    [
      'a finger that moved and came back',
      () => {
        send('move', { ...finger, clientY: 60 });
        send('move', finger);
      },
    ],
    ['a second finger', () => send('down', { ...finger, pointerId: 2, isPrimary: false, clientX: 180 })],
    ['a tap', () => send('up', finger)],
    ['a press that the device took away', () => send('cancel', finger)],
    ['a handle below the finger', () => (state.isHot = true)],
    ['a canvas that is gone', () => press.dispose()],
  ])('does not open for %s', (_, happens) => {
    send('down', finger);
    vi.advanceTimersByTime(200);
    happens();
    vi.advanceTimersByTime(2000);
    expect(open).not.toHaveBeenCalled();
    expect(stopped).not.toHaveBeenCalled();
  });

  it.each<[string, () => void]>([
    ['drags', () => send('move', { ...mouse, clientX: 105 })],
    ['flies', () => (state.flew = true)],
    ['is pressed during a drag of a handle', () => (state.isDragging = true)],
  ])('does not open where the right button %s', (_, happens) => {
    send('down', mouse);
    happens();
    send('up', mouse);
    expect(open).not.toHaveBeenCalled();
  });

  it('does not open for the left button, nor while input goes to the scene', () => {
    send('down', { ...mouse, button: 0 });
    vi.advanceTimersByTime(2000);
    send('up', { ...mouse, button: 0 });
    state.sceneListens = true;
    send('down', finger);
    vi.advanceTimersByTime(2000);
    expect(open).not.toHaveBeenCalled();
  });
});
