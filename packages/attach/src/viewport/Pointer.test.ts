import { BoxGeometry, Mesh, OrthographicCamera, Scene, type WebGLRenderer } from 'three';
import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { Session } from '../model/Session';
import type { Gizmo } from './Gizmo';
import { Pointer } from './Pointer';

type Listener = (event: object) => void;

const listeners = new Map<string, Listener>();
/** A canvas of 200 × 100 CSS pixels at the window's corner. */
const canvas = {
  getBoundingClientRect: () => ({ left: 0, top: 0, width: 200, height: 100 }),
  ...{ offsetWidth: 200, offsetHeight: 100, clientWidth: 200, clientHeight: 100, clientLeft: 0, clientTop: 0 },
};
/** x coordinates on the canvas: on the left box, on the right box, on neither. */
const [LEFT, RIGHT, NONE] = [50, 150, 100];

let session: Session;

beforeEach(() => {
  listeners.clear();
  vi.stubGlobal('addEventListener', (name: string, listener: Listener) => listeners.set(name, listener));
  vi.stubGlobal('getComputedStyle', () => ({}));
  const scene = new Scene();
  for (const [name, x] of [['left', -1] as const, ['right', 1] as const]) {
    const box = new Mesh(new BoxGeometry());
    box.name = name;
    box.position.x = x;
    scene.add(box);
  }
  const camera = new OrthographicCamera(-2, 2, 1, -1, 0, 10);
  camera.position.z = 5;
  for (const each of [scene, camera]) each.updateMatrixWorld();
  session = new Session(scene, camera, { domElement: canvas } as unknown as WebGLRenderer);
  const gizmo = { isDragging: false, hover: () => false } as unknown as Gizmo;
  void new Pointer(session, gizmo, canvas as unknown as HTMLElement);
});

afterEach(() => {
  vi.unstubAllGlobals();
});

/** @param to - position and event of the release */
function press(x: number, values: object = {}, to: { x?: number; as?: 'pointerup' | 'pointercancel' } = {}): string {
  const event = { target: canvas, button: 0, pointerId: 1, clientX: x, clientY: 50, ...values };
  listeners.get('pointerdown')!(event);
  listeners.get(to.as ?? 'pointerup')!({ ...event, clientX: to.x ?? x });
  return session.selection.items.map(({ name }) => name).join();
}

it('a click selects an object alone, and nothing where there is none', () => {
  expect([press(LEFT), press(RIGHT), press(NONE)]).toEqual(['left', 'right', '']);
});

it.each(['ctrlKey', 'metaKey', 'shiftKey'])('a click with %s selects one more or one less', (key) => {
  press(LEFT);
  const more = { [key]: true };
  expect([press(RIGHT, more), press(NONE, more), press(LEFT, more)]).toEqual(['left,right', 'left,right', 'right']);
});

it('a drag of the page is no click, nor is another button, another pointer or what the browser cancels', () => {
  expect(press(LEFT, {}, { x: LEFT + 3 })).toBe('left');
  expect(press(RIGHT, {}, { x: RIGHT + 5 })).toBe('left');
  expect(press(RIGHT, { button: 2 })).toBe('left');
  expect(press(RIGHT, {}, { as: 'pointercancel' })).toBe('left');
  expect(press(RIGHT, { target: {} })).toBe('left');
});
