import type { AssetLibrary, GameObject, PictureRenderer, Scene } from '@farol/engine';
import type { FarolRenderer } from '@farol/renderer';
import { isWhole } from '@farol/tools/extent';
import { expect, type Page } from '@playwright/test';
import type { Camera, Material, Object3D, WebGLRenderer } from 'three';

/** The editor's own camera of a view. */
interface EditorCameraHandle {
  readonly camera: Camera;
  readonly target: { toArray(): number[] };
  readonly orthographic: boolean;
  readonly pose: { readonly orthographic: boolean };
}

/** A view. */
interface PaneHandle {
  readonly name: string;
  readonly editorCamera: EditorCameraHandle;
  readonly rectangle: { readonly x: number; readonly y: number; readonly width: number; readonly height: number };
  readonly bounds: { readonly left: number; readonly top: number; readonly width: number; readonly height: number };
}

/** `window.editor` as far as the tests use it; documented in apps/editor/src/Editor.ts. */
export interface EditorHandle {
  readonly ready: Promise<void>;
  readonly document: {
    readonly scene: Scene;
    readonly selectedObjects: GameObject[];
    readonly selection: { readonly ids: readonly string[]; set(ids: readonly string[]): void };
    readonly edited: { subscribe(listener: () => void): () => void };
    readonly simulation: { readonly state: string; step(): void; stop(): void };
    readonly assets: AssetLibrary;
    readonly scripts: { settled(): Promise<void>; classOf(script: string): object | null };
  };
  /** Scenes of the engine's, and files. */
  readonly samples: Readonly<
    Record<
      string,
      { readonly label: string; readonly file: string | null; readonly scene: { readonly parameters: object } | null }
    >
  >;
  openFileBytes(text: string, file: { name: string; handle: null }): Promise<boolean>;
  openSample(name: string): Promise<void>;
  openScene(name: string, parameters?: Record<string, number>): Promise<void>;
  readonly microShaders: { textOf(name: string): string };
  readonly dialogs: { show(request: { kind: 'keys' | 'export' | 'welcome'; recovery: null }): Promise<boolean> };
  readonly notices: { show(kind: 'error', text: string): void };
  readonly preferences: {
    setState(values: { theme?: 'dark' | 'light'; folded?: Readonly<Record<string, boolean>> }): void;
  };
  readonly components: {
    readonly types: ReadonlyMap<string, { readonly fields: Readonly<Record<string, { readonly group?: string }>> }>;
  };
  openMicroShader(name: string, line?: number): void;
  readonly commands: {
    readonly history: readonly string[];
    readonly isDirty: boolean;
    clear(): void;
    readonly changed: { subscribe(listener: () => void): () => void };
  };
  addPlugin(plugin: {
    name: string;
    actions?: { id: string; label: string; run(): void }[];
    techniques?: Readonly<Record<string, object>>;
    microshaders?: Readonly<Record<string, string>>;
  }): void;
  removePlugin(name: string): void;
  readonly plugins: { readonly list: readonly { readonly name: string }[] };
  readonly viewport: {
    readonly canvas: HTMLCanvasElement;
    readonly camera: GameObject['object3D'];
    readonly technique: string;
    readonly mode: string;
    view: string;
    readonly statistics: { readonly frames: number };
    readonly gizmo: { readonly snapSteps: unknown; readonly isHot: boolean; readonly three: Object3D };
    readonly parts: { readonly lightHandles: { readonly part: { readonly places: readonly object[] } | null } };
    readonly editorCamera: EditorCameraHandle;
    readonly lookThrough: object | null;
    readonly panes: { readonly list: readonly PaneHandle[]; readonly active: PaneHandle };
    readonly webgl: WebGLRenderer;
    readonly farol: FarolRenderer;
    readonly picture: PictureRenderer;
    shade(pane: PaneHandle, shading: string): void;
    renderNow(): void;
    focus(): void;
    drawMaterial(material: Material, canvas: HTMLCanvasElement): Promise<void>;
    readonly addedEffects: {
      add(effect: { id: string; label: string; help: string; make(): never }): () => void;
    };
  };
  readonly worksOffline: boolean;
  readonly autosave: {
    readonly isUpToDate: boolean;
    readonly statistics: {
      readonly slices: readonly number[];
      readonly parts: number;
      readonly commits: number;
    };
  } | null;
  serialize(): string;
  openFileBytes(bytes: string, file: { name: string | null; handle: null }): Promise<boolean>;
}

declare global {
  interface Window {
    editor: EditorHandle;
  }
}

/**
 * Opens the editor without the browser's own file dialogs, and waits for its scene.
 *
 * @param scene - the temple when absent
 * @param fetchesAhead - whether the page fetches the code that it may need later; in the slice only what is used is fetched by
 *   default, as where the user saves data: 64 files take a third of a second of a core
 */
export async function openEditor(page: Page, scene?: 'empty', fetchesAhead = isWhole): Promise<void> {
  await page.addInitScript((savesData) => {
    // the fallbacks, a download and a file input, are what a test can answer
    Reflect.deleteProperty(window, 'showOpenFilePicker');
    Reflect.deleteProperty(window, 'showSaveFilePicker');
    if (savesData) Object.defineProperty(navigator, 'connection', { value: { saveData: true } });
  }, !fetchesAhead);
  await page.goto(scene ? `./?scene=${scene}` : './?welcome=no');
  await waitUntilReady(page);
  await unfoldFields(page);
}

/** Unfolds every section and group of fields, which are folded at first where all is at its default. */
export const unfoldFields = (page: Page): Promise<void> =>
  page.evaluate(() => {
    const { components, preferences } = window.editor;
    const groups = [...components.types].flatMap(([type, { fields }]) =>
      Object.values(fields).map(({ group }) => `${type}/${group}`),
    );
    const sections = [
      'Sky',
      'Fog',
      'Picture',
      'Shadows',
      'Picture effects',
      'Physics',
      'ModelRenderer/Morph targets',
      ...groups,
    ];
    preferences.setState({ folded: Object.fromEntries(sections.map((id) => [id, false])) });
  });

export async function waitUntilReady(page: Page): Promise<void> {
  await page.waitForFunction(() => 'editor' in window);
  await page.evaluate(() => window.editor.ready);
  // the panels load on their own
  await page.waitForFunction(() => window.editor.viewport.canvas.isConnected);
}

/** Goes from the temple to a scene that is quickly drawn: a camera, a sun and a sky. */
export async function openEmptyScene(page: Page): Promise<void> {
  await page.getByRole('menuitem', { name: 'File', exact: true }).click();
  await page.getByRole('menuitem', { name: 'New empty scene' }).click();
  await page.waitForFunction(() => window.editor.document.scene.name === 'Untitled');
  await menuIsGone(page);
}

/** Adds something from the Add menu: the submenu's name, if it is in one, and its own. */
export async function addObject(page: Page, ...names: string[]): Promise<void> {
  const selected = (): Promise<string> => page.evaluate(() => window.editor.document.selection.ids.join());
  const before = await selected();
  await page.getByRole('button', { name: 'Add', exact: true }).click();
  for (const name of names.slice(0, -1)) await page.getByRole('menuitem', { name, exact: true }).press('ArrowRight');
  await page.getByRole('menuitem', { name: names.at(-1), exact: true }).click();
  await menuIsGone(page);
  await expect.poll(selected).not.toBe(before);
  await inspectorFollows(page);
}

/** Waits until the inspector shows what is selected: it comes after the tree. */
export const inspectorFollows = (page: Page): Promise<void> =>
  expect(page.locator('.inspector[aria-busy="true"]')).toHaveCount(0);

/** A menu on its way out still takes letters and Escape for itself, as menus do. */
export const menuIsGone = (page: Page): Promise<void> => expect(page.getByRole('menu')).toHaveCount(0);

export const serialized = (page: Page): Promise<string> => page.evaluate(() => window.editor.serialize());

export const history = (page: Page): Promise<readonly string[]> => page.evaluate(() => window.editor.commands.history);

/** A field of the scene's object of this name, as authored. */
export const fieldOf = (page: Page, object: string, component: string, field: string): Promise<unknown> =>
  page.evaluate(([name, type, key]) => window.editor.document.scene.find(name)!.getComponent(type)!.getAuthored(key), [
    object,
    component,
    field,
  ] as const);

/** Page position (CSS pixels) of the middle of an object, after a frame is drawn. */
export const pointOf = (page: Page, object: string): Promise<{ x: number; y: number }> =>
  page.evaluate((name) => {
    const { viewport, document } = window.editor;
    viewport.renderNow();
    const { object3D } = document.scene.find(name)!;
    const place = object3D.getWorldPosition(object3D.position.clone());
    place.project(viewport.camera as never);
    const { left, top, width, height } = viewport.canvas.getBoundingClientRect();
    return { x: left + ((place.x + 1) / 2) * width, y: top + ((1 - place.y) / 2) * height };
  }, object);
