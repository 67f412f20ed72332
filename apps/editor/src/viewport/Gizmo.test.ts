import { GameObject } from '@farol/engine';
import { type Object3D, PerspectiveCamera } from 'three';
import type { TransformControls } from 'three/examples/jsm/controls/TransformControls.js';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { EditorDocument } from '../model/EditorDocument';
import { Gizmo, type GizmoMode, type SnapSteps } from './Gizmo';

/** A stub element without contents. */
const element = (): object => ({
  ...{ style: {}, classList: { add() {} }, isConnected: false, offsetWidth: 0, offsetHeight: 0 },
  ...{ setAttribute() {}, replaceChildren() {}, append() {}, remove() {} },
});

let page = new EventTarget();

beforeEach(() => {
  page = new EventTarget();
  vi.stubGlobal('window', page);
  vi.stubGlobal('document', { createElement: element });
  vi.stubGlobal('matchMedia', () => ({ matches: false }));
});

afterEach(() => vi.unstubAllGlobals());

type DragMode = Exclude<GizmoMode, 'select'>;

/** Transform field that each mode changes. */
const changed = { translate: 'position', rotate: 'rotation', scale: 'scale' } as const;

const camera = new PerspectiveCamera(50, 1, 0.1, 100);
camera.position.set(3, 4, 10);
camera.lookAt(0, 0, 0);
camera.updateMatrixWorld();

/** A gizmo on a selected object at the origin with scale 1 and no rotation. */
async function makeGizmo(): Promise<{ gizmo: Gizmo; object: GameObject; controls: TransformControls }> {
  const editorDocument = new EditorDocument();
  const object = new GameObject('Box');
  editorDocument.scene.add(object);
  editorDocument.selection.set([object.id]);
  const canvas = Object.assign(new EventTarget(), {
    ...{ style: {}, parentElement: null, clientWidth: 100, clientHeight: 100 },
    getBoundingClientRect: () => ({ left: 0, top: 0, width: 100, height: 100 }),
  }) as unknown as HTMLCanvasElement;
  let gizmo: Gizmo | null = null;
  await new Promise<void>((resolve) => {
    const nothing = (): void => {};
    gizmo = new Gizmo(editorDocument, canvas, nothing, nothing, resolve);
    gizmo.update(camera);
  });
  const { controls } = gizmo!.three.children[1] as Object3D & { controls: TransformControls };
  return { gizmo: gizmo!, object, controls };
}

/** Drags a handle and cancels. @returns the change along the axis: m, rad or a factor */
function dragged({ gizmo, object, controls }: Awaited<ReturnType<typeof makeGizmo>>, mode: DragMode, axis: 'X' | 'Y') {
  gizmo.mode = mode;
  gizmo.update(camera);
  controls.axis = axis;
  controls.getHelper().updateMatrixWorld(true);
  const pointer = (x: number, y: number, button: number) => ({ x, y, button }) as unknown as PointerEvent;
  controls.pointerDown(pointer(0.1, 0.1, 0));
  controls.pointerMove(pointer(0.25, 0.27, -1));
  const value = object.transform[changed[mode]]['XY'.indexOf(axis)];
  gizmo.cancel();
  return value;
}

const press = (ctrlKey: boolean): boolean =>
  page.dispatchEvent(Object.assign(new Event(ctrlKey ? 'keydown' : 'keyup'), { ctrlKey }));

/** Snapping steps: m, rad, share of the size. */
const steps: readonly SnapSteps[] = [
  { translate: 0.5, rotate: Math.PI / 12, scale: 0.1 },
  { translate: 0.25, rotate: Math.PI / 4, scale: 0.3 },
  { translate: 0.7, rotate: Math.PI / 90, scale: 0.25 },
];

describe.each(['translate', 'rotate', 'scale'] as const)('%s', (mode) => {
  it.each(['X', 'Y'] as const)('along %s goes by whole steps while it snaps, and freely else', async (axis) => {
    const handles = await makeGizmo();
    const { gizmo } = handles;
    const free = dragged(handles, mode, axis);
    for (const snapSteps of steps) {
      gizmo.snapping = true;
      gizmo.snapSteps = snapSteps;
      const step = snapSteps[mode];
      const stepped = Math.round(free / step) * step;
      // must differ from a step, or snapping would not be tested
      expect(Math.abs(free - stepped)).toBeGreaterThan(0.01 * step);
      const expectDrag = (value: number): void => expect(dragged(handles, mode, axis)).toBeCloseTo(value, 4);
      expectDrag(stepped);
      gizmo.snapTo = 'vertex';
      expectDrag(mode === 'translate' ? free : stepped);
      gizmo.snapTo = 'grid';
      press(true);
      expectDrag(free);
      press(false);
      gizmo.snapping = false;
      expectDrag(free);
      press(true);
      expectDrag(stepped);
      press(false);
    }
    gizmo.dispose();
  });
});

it('steps are half a metre, 15 degrees and a tenth until others are chosen', async () => {
  const { gizmo } = await makeGizmo();
  expect(gizmo.snapSteps).toEqual(steps[0]);
  gizmo.dispose();
});
