import { byExtent } from '@farol/tools/extent';
import type { CDPSession } from '@playwright/test';
import { expect, test } from '../support/test';
import { openEditor } from './editor';

test.use({ viewport: { width: 420, height: 320 }, reducedMotion: 'reduce' });

/** Edits before the first count, in which caches of bounded size fill, and until the last one. */
const FIRST = 100;
const EDITS = byExtent({ slice: FIRST, verify: 500 });

/** Prototypes whose objects are counted, as expressions. */
const PROTOTYPES = {
  GameObject: 'Object.getPrototypeOf(editor.document.scene.roots[0])',
  Object3D: `(() => {
    let found;
    for (let at = editor.document.scene.three; at; at = Object.getPrototypeOf(at))
      if (Object.hasOwn(at, 'updateMatrixWorld')) found = at;
    return found;
  })()`,
  Map: 'Map.prototype',
  Set: 'Set.prototype',
  Array: 'Array.prototype',
};

/** Objects that can be reached once garbage is collected, by kind. */
async function reachable(client: CDPSession): Promise<Record<string, number>> {
  const counts: Record<string, number> = {};
  const objectGroup = 'counts';
  await client.send('HeapProfiler.collectGarbage');
  for (const [kind, expression] of Object.entries(PROTOTYPES)) {
    const { result } = await client.send('Runtime.evaluate', { expression, objectGroup });
    const { objects } = await client.send('Runtime.queryObjects', { prototypeObjectId: result.objectId!, objectGroup });
    const length = await client.send('Runtime.callFunctionOn', {
      objectId: objects.objectId!,
      functionDeclaration: 'function () { return this.length; }',
      returnByValue: true,
    });
    counts[kind] = length.result.value as number;
    await client.send('Runtime.releaseObjectGroup', { objectGroup });
  }
  return counts;
}

test('edits that are undone leave nothing that can be reached @verify', async ({ page }) => {
  test.slow();
  await openEditor(page);
  await page.evaluate(async () => {
    const { editor } = window as unknown as {
      editor: typeof window.editor & {
        actions: { get(id: string): { run(editor: unknown): unknown } };
        commands: { undo(): void };
      };
    };
    const { document, viewport } = editor;
    await editor.openSample(
      Object.keys(editor.samples).find((name) => editor.samples[name].label === 'Night in the temple')!,
    );
    await document.scripts.settled();
    const draw = viewport.renderNow.bind(viewport);
    // a frame takes the software rasteriser seconds: a few of the edits are drawn
    viewport.renderNow = () => {};
    let count = 0;
    const edit = async () => {
      const isDrawn = count++ % 25 === 0;
      document.selection.set(document.scene.roots.slice(0, 40).map(({ id }) => id));
      await editor.actions.get('edit.duplicate').run(editor);
      if (isDrawn) draw();
      editor.commands.undo();
      if (isDrawn) draw();
      // the panels follow
      await new Promise(requestAnimationFrame);
    };
    Object.assign(window, {
      edits: async (count: number) => {
        for (let i = 0; i < count; i++) await edit();
        draw();
        draw();
      },
    });
  });
  const client = await page.context().newCDPSession(page);
  const after = async (edits: number) => {
    await page.evaluate((count) => (window as unknown as { edits(count: number): Promise<void> }).edits(count), edits);
    return reachable(client);
  };
  const first = await after(FIRST);
  const last = await after(EDITS - FIRST);
  expect(first.GameObject).toBeGreaterThan(500);
  expect(last.GameObject, 'objects of the scene').toBeLessThanOrEqual(first.GameObject);
  // an edit makes dozens of each
  for (const kind of ['Object3D', 'Map', 'Set', 'Array'])
    expect.soft(last[kind] - first[kind], `${kind}: less than one for an edit`).toBeLessThan(EDITS - FIRST);
});
