import type { Page } from '@playwright/test';
import { expect, testWithSharedPage } from '../support/sharedPage';
import { openEditor, unfoldFields } from './editor';

export { expect };

/** The parts of `window.editor` that are put back between tests; documented in apps/editor/src/Editor.ts. */
interface Kept {
  readonly actions: { get(id: string): { run(editor: unknown): Promise<void> } | undefined };
  readonly clipboard: { text: string | null };
  readonly commands: { readonly history: readonly string[]; readonly isDirty: boolean; clear(): void };
  readonly dialogs: { readonly current: object | null; close(agreed: boolean): void };
  readonly document: (typeof window.editor)['document'];
  readonly keys: { readonly store: { getState(): object }; reset(): void };
  readonly layout: {
    maximised(): string | null;
    sheet(): string | null;
    isSmall(): boolean;
    open(panel: string): void;
    close(panel: string): void;
    reset(): void;
  };
  readonly log: { readonly entries: readonly object[]; clear(): void };
  /** Microshaders of the scene in the renderers of viewport and previews; private in MicroShaderEditing.ts. */
  readonly microShaders: { readonly overrides: readonly { readonly applied: ReadonlyMap<string, string> }[] };
  readonly notices: { readonly current: readonly { readonly id: number }[]; remove(id: number): void };
  readonly panels: { readonly list: readonly { readonly id: string }[] };
  readonly plugins: { readonly list: readonly { readonly name: string }[] };
  removePlugin(name: string): void;
  readonly preferences: {
    getInitialState(): object;
    getState(): object;
    setState(values: object, replaces: boolean): void;
  };
  readonly recentFiles: { list: readonly object[] };
  serialize(): string;
  readonly tools: { readonly current: object | null; end(): boolean };
  readonly tour: { readonly current: number | null; show(step: null): void };
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
async function putBack(page: Page): Promise<void> {
  await page.mouse.move(0, 0);
  await page.evaluate(async (settings) => {
    const editor = window.editor as unknown as Kept;
    editor.dialogs.close(false);
    editor.tools.end();
    editor.tour.show(null);
    for (const { name } of editor.plugins.list) editor.removePlugin(name);
    localStorage.clear();
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
  await unfoldFields(page);
  await expect(page.getByRole('dialog').or(page.getByRole('menu'))).toHaveCount(0);
}

/** Puts the editor back; once more where something that the test before began ended only then. */
const reset = (page: Page): Promise<void> =>
  expect(async () => {
    await putBack(page);
    expect(await stateOf(page), 'an editor that was put back').toEqual(opened);
  }).toPass({ timeout: 30_000 });

/** State of an editor as it opens. */
let opened: object;

/**
 * State of the editor that a test may leave changed. Without ids, the order of panels (it follows the size of the window) and
 * recent files, which are noted a while after they were opened.
 */
const stateOf = (page: Page): Promise<object> =>
  page.evaluate((names) => {
    const editor = window.editor as unknown as Kept;
    const { clipboard, commands, dialogs, keys, layout, log, notices, plugins, preferences, tools, tour } = editor;
    const { microShaders, viewport } = editor;
    return {
      edited: microShaders.overrides.flatMap(({ applied }) => [...applied.keys()]),
      scene: editor.serialize().replaceAll(/"(id|parent|activeCamera)": "[^"]+"/g, '"$1"'),
      assets: editor.document.assets.files.length,
      simulation: editor.document.simulation.state,
      selection: editor.document.selection.ids,
      commands: [commands.history, commands.isDirty],
      preferences: preferences.getState(),
      keys: keys.store.getState(),
      layout: [layout.maximised(), layout.isSmall() ? layout.sheet() : null],
      plugins: plugins.list.map(({ name }) => name),
      shown: [dialogs.current, notices.current, tools.current, tour.current, log.entries],
      clipboard: clipboard.text,
      fields: document.querySelector<HTMLInputElement>('.inspector .search')?.value ?? '',
      storage: Object.keys(localStorage).filter((key) => !key.startsWith('farol-editor')),
      viewport: names.map((name) => viewport[name]),
      document: { ...document.documentElement.dataset, language: document.documentElement.lang },
    };
  }, Object.keys(viewportSettings));

async function open(page: Page): Promise<void> {
  await openEditor(page, 'empty');
  opened = await stateOf(page);
}

/** `test` with an editor that shows the empty scene, which opens once for the tests of a worker. */
export const test = testWithSharedPage('editor', open, reset).extend({
  viewport: { width: 1000, height: 560 },
  reducedMotion: 'reduce',
});
