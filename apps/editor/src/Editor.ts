import { type Command, type CommandStack, Signal, t } from '@farol/editing';
import { type AssetLibrary, audioOutput, builtinComponents, ComponentRegistry, type Scene } from '@farol/engine';
import { FileError, type ForeignAddress, type UnpackQuestion } from '@farol/engine/files';
import { type SceneParameters, scenes } from '@farol/scenes';
import { MathUtils } from 'three';
import { actions, allActions } from './actions';
import type { EditorPlugin } from './api/EditorPlugin';
import type { CustomFieldEditor, DraftKeeper, EditorApi, OpenFile } from './api/EditorApi';
import type { Action } from './api/Action';
import { KeyBindings } from './api/KeyBindings';
import { samples } from './api/Sample';
import { createPreferences, type Preferences, type PreferenceStore } from './api/preferences';
import { PanelLayout } from './layout/PanelLayout';
import { PanelRegistry } from './layout/PanelRegistry';
import { Clipboard } from './model/Clipboard';
import { ConsoleLog } from './model/ConsoleLog';
import { Drafts } from './model/Drafts';
import { MicroShaderEditing } from './microshaders/MicroShaderEditing';
import { Dialogs } from './model/Dialogs';
import { EditorDocument } from './model/EditorDocument';
import { Notices } from './model/Notices';
import { PlaceToShow } from './model/PlaceToShow';
import { RecentFiles } from './model/RecentFiles';
import { Tools } from './model/Tools';
import { Registry } from './model/Registry';
import type { Timeline } from './model/timeline/Timeline';
import { Tour } from './model/Tour';
import { panels } from './panels';
import { applyViews, type ViewChoice } from './viewport/panes/ViewChoice';
import { Viewport } from './viewport/Viewport';
import { guardScripts } from './scripts/guardScripts';
import { Plugins } from './plugins/Plugins';
import { unknownTypes } from './model/unknownTypes';
import { makeLibrary } from './files/makeLibrary';
import { openFirst } from './files/openFirst';
import { withProgress } from './files/withProgress';
import { watchErrors } from './watchErrors';

/** Time of successful drawing after which the notice of a drawing failure is removed (ms). */
const RECOVERED = 1000;

/** Delay before drawing is retried after a failed frame (ms). */
const RETRY = 8000;

export interface EditorOptions {
  /** First scene: a name of the engine's `scenes`, or 'empty'; the temple when absent or null. */
  scene?: string | null;
  /**
   * Prefix of the keys in localStorage for preferences, key bindings and layout; 'farol-editor' when absent. Editors of
   * one page that need separate settings use different ones.
   */
  storage?: string;
}

/**
 * The whole editor apart from its panels. The page exposes it as `window.editor` for tests and for the console:
 *
 * - `ready`: promise, fulfilled when the first scene is loaded and drawn
 * - `document`: scene, selection, simulation, and `commands`, the history
 * - `viewport`: canvas, camera, gizmo, FarolRenderer (`viewport.farol`), `renderNow()`, `pick(point)`
 * - `commands`: the same as `document.commands`
 * - `addPlugin(plugin)`: adds panels, components, types of fields, techniques, effects, microshaders and commands;
 *   `removePlugin(name)` takes all of them out
 * - `serialize()`: the scene as the text of a file
 */
export class Editor implements EditorApi {
  readonly actions = new Registry('an action', actions);
  readonly panels = new PanelRegistry(panels);
  readonly components = new ComponentRegistry(builtinComponents.types.values(), { keepUnknown: true });
  readonly fieldEditors = new Registry<CustomFieldEditor>('a type of fields', []);
  readonly keys: KeyBindings<Action>;
  readonly layout: PanelLayout;
  readonly preferences: PreferenceStore;
  readonly document: EditorDocument;
  readonly viewport: Viewport;
  readonly microShaders: MicroShaderEditing;
  readonly microShaderPlace = new PlaceToShow();
  readonly scriptPlace = new PlaceToShow();
  readonly dialogs = new Dialogs();
  readonly clipboard = new Clipboard();
  readonly tools = new Tools();
  readonly log = new ConsoleLog();
  readonly notices = new Notices(this.log);
  readonly drafts = new Drafts();
  readonly recentFiles = new RecentFiles();
  readonly tour = new Tour();
  readonly phones = { text: '', changed: new Signal() };
  readonly renameRequested = new Signal();
  readonly fileChanged = new Signal();
  readonly plugins: Plugins = new Plugins(this);
  readonly samples = samples;
  readonly ready: Promise<void>;
  autosave: DraftKeeper | null = null;
  timeline: Timeline | null = null;
  worksOffline = false;

  private openFile: OpenFile = { name: null, handle: null };
  /** Number of scenes being read. */
  private reading = 0;
  private turn = 0;

  /** @param canvas - canvas of the viewport @throws Error when the browser has no WebGL 2 */
  constructor(canvas: HTMLCanvasElement, options: EditorOptions = {}) {
    const { scene = null, storage = 'farol-editor' } = options;
    const all = (): Action[] => allActions(this);
    this.keys = new KeyBindings(
      {
        get list() {
          return all();
        },
      },
      `${storage}-keys`,
    );
    this.layout = new PanelLayout(this.panels, `${storage}-layout`);
    this.preferences = createPreferences(storage);
    this.document = new EditorDocument(makeLibrary(), this.components);
    this.viewport = new Viewport(this.document, canvas);
    this.document.onAssetFailed = (error) => this.notices.show('error', error.message, 'asset');
    this.watchPicture();
    this.watchPreferences();
    watchErrors(this);
    guardScripts(this.document);
    this.microShaders = new MicroShaderEditing(this.document, this.viewport.farol.microshaders, this.log);
    this.viewport.shareMicroShaders = (registry) => this.microShaders.addRegistry(registry);
    // fetched before the first frame, which may need these microshaders
    const read = (build: (assets: AssetLibrary) => Promise<Scene>): Promise<Scene | null> => this.readNext(build);
    this.ready = this.viewport.farol.addLazyMicroShaders().then(() => openFirst(this, scene, read));
  }

  get commands(): CommandStack {
    return this.document.commands;
  }

  get file(): OpenFile {
    return this.openFile;
  }

  saved(file: OpenFile, step: Command | null): void {
    this.openFile = file;
    this.commands.markSaved(step);
    this.fileChanged.emit();
  }

  serialize(): string {
    return this.document.serialize();
  }

  async openScene(name: string, parameters: SceneParameters = {}): Promise<void> {
    const scene = await this.readNext((assets) => scenes[name].build(parameters, assets));
    if (scene) this.show(scene, { name: null, handle: null });
  }

  async openSample(name: string): Promise<void> {
    const { file, scene } = this.samples[name];
    if (file === null) return this.openScene(name, scene?.sample);
    const { readSample } = await import('./files/readSample');
    const read = await this.readNext((assets) => readSample(this, file, assets));
    if (read) this.show(read, { name: null, handle: null });
  }

  /** @returns null when another scene was opened or shown meanwhile */
  private async readNext(read: (assets: AssetLibrary) => Promise<Scene>): Promise<Scene | null> {
    const turn = ++this.turn;
    const assets = this.libraryForNext();
    this.reading++;
    let scene: Scene | null = null;
    try {
      scene = await read(assets);
      return turn === this.turn ? scene : null;
    } catch (error) {
      // the library was disposed of with its scene
      if (turn !== this.turn) return null;
      throw error;
    } finally {
      this.reading--;
      if (!scene || turn !== this.turn) {
        scene?.dispose();
        if (assets !== this.document.assets) assets.dispose();
      }
    }
  }

  libraryForNext(): AssetLibrary {
    const { assets } = this.document;
    // the present scene stays if the file is refused, so the file must not add to a library in use
    if (!assets.hasOwn && !this.commands.isDirty && this.reading === 0) return assets;
    return makeLibrary({ renderer: this.viewport.webgl });
  }

  async openFileBytes(
    bytes: Uint8Array | string,
    file: OpenFile,
    fileOf?: (path: string) => Blob | null,
  ): Promise<boolean> {
    try {
      const { deserialize, readSceneFile, seenFile } = await import('./files/readScene');
      const seen = typeof bytes === 'string' ? file : await seenFile(bytes, file);
      const content = typeof bytes === 'string' ? { text: bytes, fileOf } : await readSceneFile(bytes, this.mayUnpack);
      const mayFetch = async (addresses: readonly ForeignAddress[]): Promise<boolean> => {
        const { askForHosts } = await import('./files/askForHosts');
        return askForHosts(this.dialogs, file.name ?? t('The scene'), addresses);
      };
      const title = t('Opening {file}', { file: file.name ?? t('the scene') });
      const scene = await this.readNext((assets) =>
        withProgress(this.dialogs, title, (signal) =>
          deserialize(content.text, {
            assets,
            registry: this.document.scripts.withoutScripts(this.components),
            fileOf: content.fileOf,
            mayFetch,
            signal,
          }),
        ),
      );
      if (!scene) return false;
      // the user is asked last, once the file is known to be valid
      if (!(await this.mayLoseChanges())) {
        const { assets } = scene;
        scene.dispose();
        if (assets !== this.document.assets) assets.dispose();
        return false;
      }
      this.show(scene, seen, await this.mayRunScripts(scene));
      if (typeof bytes !== 'string') this.remember(bytes);
      return true;
    } catch (error) {
      if (error instanceof DOMException && error.name === 'AbortError') return false;
      if (!(error instanceof FileError)) throw error;
      const title = t('{file} cannot be opened', { file: file.name ?? t('The file') });
      const { problems } = error;
      for (const { path, problem } of problems)
        this.log.add('error', 'file', `${file.name ?? t('The file')}: ${path} ${problem}`);
      void this.dialogs.show({
        kind: 'problems',
        title,
        text: t('Nothing has changed. What is wrong with it:'),
        problems,
      });
      return false;
    }
  }

  readonly mayUnpack = async (sizes: UnpackQuestion): Promise<boolean> => {
    const { sizesText } = await import('./files/readScene');
    return this.dialogs.show({
      kind: 'confirm',
      title: t('A large scene'),
      text: t(
        'The scene grows {sizes} when it is unpacked, which may take long or end this tab. Open it only if you know where it comes from.',
        { sizes: sizesText(sizes) },
      ),
      action: t('Open it'),
    });
  };

  async mayLoseChanges(): Promise<boolean> {
    if (!this.commands.isDirty) return true;
    const { askToSave } = await import('./actions/askToSave');
    return askToSave(this);
  }

  attempt(run: () => unknown): void {
    const failed = (error: unknown): void => {
      if (error instanceof DOMException && error.name === 'AbortError') return;
      if (error instanceof FileError) {
        const { problems } = error;
        const text = t('Nothing has changed. What is wrong with it:');
        void this.dialogs.show({ kind: 'problems', title: t('This cannot be read'), text, problems });
        return;
      }
      this.notices.show('error', error instanceof Error ? error.message : String(error));
    };
    try {
      const result = run();
      if (result instanceof Promise) result.catch(failed);
    } catch (error) {
      failed(error);
    }
  }

  addPlugin(plugin: EditorPlugin): void {
    this.plugins.add(plugin);
  }

  removePlugin(name: string): void {
    this.plugins.remove(name);
  }

  openMicroShader(chunk: string, line = 0): void {
    this.microShaderPlace.show({ name: chunk, line });
    this.layout.open('microshaders');
  }

  openScript(name: string, line = 0): void {
    this.scriptPlace.show({ name, line });
    this.layout.open('scripts');
  }

  show(scene: Scene, file: OpenFile, runsScripts = true): void {
    this.tools.end();
    this.turn++;
    this.document.open(scene, runsScripts);
    this.openFile = file;
    this.fileChanged.emit();
    this.viewport.renderNow();
    void this.document.scripts.settled().then(() => this.document.scene === scene && this.tellOfUnknown());
  }

  private async mayRunScripts(scene: Scene): Promise<boolean> {
    if (scene.assets.fieldAssets('script').length === 0) return true;
    return (await import('./scripts/knownScripts')).mayRunScripts(scene);
  }

  private tellOfUnknown(): void {
    const { scripts, scene } = this.document;
    const unknown = unknownTypes(scene);
    // while scripts are off, their banner explains components kept as data
    if (unknown.length === 0 || (scripts.areThere && !scripts.isOn)) return;
    const text = t(
      'These components are unknown, so they are kept as data: {names}. Add the plugin or script that has them.',
      { names: unknown.join(', ') },
    );
    this.notices.show('warning', text, 'plugin');
  }

  /** Adds the file that was just opened to the recent files. */
  private remember(bytes: Uint8Array): void {
    const content = new Blob([bytes as Uint8Array<ArrayBuffer>]);
    this.attempt(async () => {
      const { noteRecent } = await import('./files/recent/noteRecent');
      await noteRecent(this, content, false);
    });
  }

  private watchPreferences(): void {
    let appliedViews: ViewChoice | null = null;
    const apply = ({ snapSteps, snapTo, alignsToSurface, pivot, views, isMuted }: Preferences): void => {
      if (views !== appliedViews) applyViews(this.viewport, (appliedViews = views));
      audioOutput.muted = isMuted;
      const { translate, rotate, scale } = snapSteps;
      this.viewport.gizmo.snapSteps = { translate, rotate: MathUtils.degToRad(rotate), scale };
      Object.assign(this.viewport, { snapTo, alignsToSurface, pivot });
    };
    apply(this.preferences.getState());
    this.preferences.subscribe(apply);
  }

  private watchPicture(): void {
    const { viewport, notices } = this;
    /** Ids of notices that drawing failed. */
    const failures = new Set<number>();
    let failedAt = 0;
    let timer: ReturnType<typeof setTimeout> | undefined;
    viewport.onError = (error) => {
      failedAt = performance.now();
      clearTimeout(timer);
      timer = setTimeout(() => viewport.invalidate(), RETRY);
      const text = t('The picture cannot be drawn: {reason}', {
        reason: error instanceof Error ? error.message : String(error),
      });
      if (notices.current.some((notice) => notice.text === text)) return;
      console.error(error);
      failures.add(notices.show('error', text, 'picture', { lasts: true }));
    };
    viewport.drawn.subscribe(() => {
      if (failures.size === 0 || performance.now() - failedAt < RECOVERED) return;
      for (const failure of failures) notices.remove(failure);
      failures.clear();
    });
    let loss = 0;
    viewport.canvas.addEventListener('webglcontextlost', () => {
      const text = t('The graphics device was lost. The picture comes back by itself; if not, save and reload.');
      loss = notices.show('error', text, 'picture', { lasts: true });
    });
    viewport.canvas.addEventListener('webglcontextrestored', () => notices.remove(loss));
  }
}
