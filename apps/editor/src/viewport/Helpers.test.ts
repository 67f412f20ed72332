import { GameObject, Light } from '@farol/engine';
import { type BufferAttribute, PerspectiveCamera, type WebGLRenderer } from 'three';
import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { EditorDocument } from '../model/EditorDocument';
import { Helpers } from './Helpers';
import { IconPoints } from './IconPoints';
import { SceneStamps } from './SceneStamps';
// imported here, so that the helpers' late import resolves at once
import './SelectionLines';

beforeEach(() => {
  const context = new Proxy({}, { get: () => () => {}, set: () => true });
  vi.stubGlobal('document', { createElement: () => ({ getContext: () => context }) });
  vi.stubGlobal('Path2D', Object);
});
afterEach(() => vi.unstubAllGlobals());

/** Helpers over a scene with one box; `draw` renders them with a stub. */
function open() {
  const document = new EditorDocument();
  const box = new GameObject('Box');
  document.scene.add(box);
  const redraw = vi.fn<() => void>();
  const failed = vi.fn<(error: unknown) => void>();
  const helpers = new Helpers(document, new SceneStamps(document, () => {}), redraw, failed);
  const webgl = { autoClear: true, render: () => {}, getPixelRatio: () => 1 } as unknown as WebGLRenderer;
  const draw = async (): Promise<void> => {
    helpers.render(webgl, new PerspectiveCamera(), null, false);
    for (let i = 0; i < 3; i++) await import('./SelectionLines');
  };
  return { document, box, helpers, redraw, failed, draw };
}

it('the picture is drawn anew once the lines of the first selection are fetched, and not before', async () => {
  const { document, box, helpers, redraw, failed, draw } = open();
  await draw();
  expect(redraw).not.toHaveBeenCalled();
  const before = helpers.scene.children.length;
  document.selection.set([box.id]);
  await draw();
  expect(redraw).toHaveBeenCalledTimes(1);
  expect(helpers.scene.children.length).toBeGreaterThan(before);
  expect(failed).not.toHaveBeenCalled();
  helpers.dispose();
  expect(helpers.scene.children).toHaveLength(before);
});

it('the picture is drawn anew once the lines of ranges are fetched, with nothing selected', async () => {
  const { helpers, redraw, draw } = open();
  helpers.showRanges = true;
  await draw();
  expect(redraw).toHaveBeenCalledTimes(1);
  helpers.dispose();
});

it('icons are written anew when lights move or change their colour, not when they are dimmed or the view turns', async () => {
  const { document, box, helpers, draw } = open();
  const light = box.addComponent(Light);
  const { attributes } = (helpers.scene.children.find((each) => each instanceof IconPoints) as IconPoints).geometry;
  const written: number[] = [];
  const after = async (edit: () => void): Promise<void> => {
    edit();
    await draw();
    written.push((attributes.tint as BufferAttribute).version);
  };
  await after(() => {});
  await after(() => {});
  await after(() => (light.intensity = 3));
  await after(() => document.selection.set([box.id]));
  expect([attributes.selected.array[0], ...written]).toEqual([1, 1, 1, 1, 1]);
  await after(() => (light.diffuse = [1, 0, 0]));
  await after(() => (box.transform.position = [1, 2, 3]));
  expect(written.slice(-2)).toEqual([2, 3]);
});
