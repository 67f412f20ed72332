import type { Page } from '@playwright/test';
import { test as base } from '../support/test';
import { openEditor } from './editor';

export { expect } from '@playwright/test';

/** The parts of `window.editor` that are put back between tests; documented in apps/editor/src/Editor.ts. */
interface Kept {
  readonly actions: { get(id: string): { run(editor: unknown): Promise<void> } | undefined };
  readonly clipboard: { text: string | null };
  readonly commands: { clear(): void };
  readonly dialogs: { close(agreed: boolean): void };
  readonly keys: { reset(): void };
  readonly layout: { close(panel: string): void; isSmall(): boolean; open(panel: string): void; reset(): void };
  readonly log: { clear(): void };
  readonly notices: { readonly current: readonly { readonly id: number }[]; remove(id: number): void };
  readonly panels: { readonly list: readonly { readonly id: string }[] };
  readonly plugins: { readonly list: readonly { readonly name: string }[] };
  removePlugin(name: string): void;
  readonly preferences: { getInitialState(): object; setState(values: object, replaces: boolean): void };
  readonly recentFiles: { list: readonly object[] };
  readonly tools: { end(): boolean };
  readonly tour: { show(step: null): void };
  readonly viewport: Record<string, unknown>;
}

/** Settings of the viewport that are neither the scene's nor kept preferences, as they are at first. */
const viewportSettings = {
  view: 'final',
  mode: 'translate',
  space: 'world',
  snapping: false,
  showGrid: true,
  showIcons: true,
  showPictureEffects: true,
  showRanges: false,
  showColliders: false,
  continuous: false,
  showStatistics: false,
  painter: null,
};

/** Puts the editor back to how it opens with the empty scene: all that is kept in the page and in the browser's storage. */
async function reset(page: Page): Promise<void> {
  await page.mouse.move(0, 0);
  await page.evaluate(async (settings) => {
    const editor = window.editor as unknown as Kept;
    editor.dialogs.close(false);
    editor.tools.end();
    editor.tour.show(null);
    for (const { name } of editor.plugins.list) editor.removePlugin(name);
    editor.keys.reset();
    editor.preferences.setState(editor.preferences.getInitialState(), true);
    editor.clipboard.text = null;
    // every panel but the picture is made anew
    for (const { id } of editor.panels.list) editor.layout.close(id);
    editor.commands.clear();
    await editor.actions.get('file.new')!.run(editor);
    Object.assign(editor.viewport, settings);
    await new Promise(requestAnimationFrame);
    editor.layout.reset();
    if (editor.layout.isSmall()) editor.layout.open('viewport');
    for (const { id } of editor.notices.current) editor.notices.remove(id);
    editor.log.clear();
    editor.recentFiles.list = [];
    for (const { name } of await indexedDB.databases()) {
      if (name !== 'farol-recent') continue;
      const opened = indexedDB.open(name);
      const database = await new Promise<IDBDatabase>((resolve) => (opened.onsuccess = () => resolve(opened.result)));
      const stores = [...database.objectStoreNames];
      for (const store of stores) database.transaction(store, 'readwrite').objectStore(store).clear();
      database.close();
    }
    (document.activeElement as HTMLElement | null)?.blur();
  }, viewportSettings);
  await base.expect(page.getByRole('dialog').or(page.getByRole('menu'))).toHaveCount(0);
}

/**
 * As `test` of ../support/test, with one page for all tests of a worker: the editor with the empty scene, which opens once,
 * and is put back before each test. For tests that neither reload the page nor change what it runs on: its storage, its
 * network, what the browser can do.
 */
export const test = base.extend<{ emptyScene: void }, { sharedPage: Page }>({
  sharedPage: [
    async ({ browser }, use) => {
      const baseURL = process.env.FAROL_EDITOR_URL;
      const context = await browser.newContext({ baseURL });
      await use(await context.newPage());
      await context.close();
    },
    { scope: 'worker' },
  ],

  context: async ({ sharedPage }, use) => use(sharedPage.context()),

  page: async ({ sharedPage }, use) => {
    await use(sharedPage);
    for (const other of sharedPage.context().pages()) if (other !== sharedPage) await other.close();
  },

  viewport: { width: 1000, height: 560 },

  reducedMotion: 'reduce',

  emptyScene: [
    async ({ page, viewport, reducedMotion, watch }, use) => {
      void watch;
      await page.setViewportSize(viewport!);
      await page.emulateMedia({ reducedMotion });
      if (page.url() === 'about:blank') await openEditor(page, 'empty');
      else await reset(page);
      await use();
    },
    { auto: true },
  ],
});
