import { type Command, CommandStack, Selection as AssetSelection, Signal, t } from '@farol/editing';
import {
  AssetLibrary,
  type Component,
  ComponentRegistry,
  type GameObject,
  Scene,
  type SceneChange,
} from '@farol/engine';
import type { FieldOwner } from '@farol/engine/fields';
import { serialize } from '@farol/engine/files';
import { DocumentScripts } from './DocumentScripts';
import { PlayEdits } from './PlayEdits';
import { Selection } from './Selection';
import { Simulation } from './Simulation';

type OwnerSignal = Signal<readonly [field?: string]>;

/**
 * The edited scene with its history, selection and simulation, without React or a canvas. Every edit goes through
 * `commands`; simulation writes to the scene directly and never becomes history.
 */
export class EditorDocument {
  readonly commands = new CommandStack((command, isDone) => this.applied(command, isDone));
  readonly selection = new Selection();
  /** Edits made while the scene played. */
  readonly playEdits = new PlayEdits(this);
  readonly simulation = new Simulation(() => this.scene, this.playEdits);
  /** The scene's scripts: whether they run, and their errors. */
  readonly scripts: DocumentScripts;
  /** Emits after every edit of any kind, previews included. */
  readonly edited = new Signal();
  /** Emits when objects or components are added, removed, moved, renamed, or switched on or off. */
  readonly structure = new Signal();
  /** Emits when another scene was opened. */
  readonly opened = new Signal();
  /**
   * Emits when an asset of the scene's library is added, loaded, fails or is removed, and when the library is replaced.
   */
  readonly assetsChanged = new Signal();
  /** Emits when a prefab of the scene changes, or an object becomes an instance of one or stops being one. */
  readonly prefabs = new Signal();
  /** Called with the error when an asset fails to load. */
  onAssetFailed: (error: Error) => void = () => {};
  /** Names of assets whose failure is reported by the code that loads them, not by `onAssetFailed`. */
  readonly toldElsewhere = new Set<string>();
  /** Emits every change of the document's scene as it is made, previews included. */
  readonly sceneChanged = new Signal<[SceneChange]>();
  /** Emits when a field of a material of the library changes. */
  readonly materials = new Signal();
  /** Selected assets: names, or ids of prefabs. The inspector shows the last one. */
  readonly assetSelection = new AssetSelection<string>();
  /** Emits when a view stored with the scene changes. */
  readonly views = new Signal();
  /** Emits when the stopped scene shows other values because an animation clip is previewed. */
  readonly previewed = new Signal();
  /** Emits when a microshader of the scene changes. */
  readonly microShaders = new Signal();
  /** Called with the error that a component throws while the scene plays. */
  onComponentError: (component: Component, error: unknown) => void = () => {};

  private current: Scene;
  private unsubscribe: () => void;
  private endAssets: () => void = () => {};
  private readonly ownerSignals = new WeakMap<FieldOwner, OwnerSignal>();

  /**
   * @param registry - component types shared by every scene of the document; each scene's own when absent
   * @param scripts - runs the scripts; in the page when absent
   */
  constructor(
    assets: AssetLibrary = new AssetLibrary(),
    private readonly registry?: ComponentRegistry,
    scripts = new DocumentScripts(),
  ) {
    this.scripts = scripts;
    this.current = new Scene({ name: t('Untitled'), assets, registry });
    this.watchAssets();
    this.unsubscribe = this.watch(this.current);
    this.selection.onSet = () => this.assetSelection.clear();
    this.openScripts(true);
  }

  get scene(): Scene {
    return this.current;
  }

  get assets(): AssetLibrary {
    return this.current.assets;
  }

  /** The selected GameObjects, in the order they were selected. */
  get selectedObjects(): GameObject[] {
    return this.selection.ids.flatMap((id) => this.scene.findById(id) ?? []);
  }

  /**
   * Shows another scene, with an empty history. The previous scene is disposed of.
   * @param runsScripts - whether its scripts run; those of an untrusted scene are off until the user allows them
   */
  open(scene: Scene, runsScripts = true): void {
    const previous = this.current;
    this.scripts.close();
    this.commands.clear();
    this.unsubscribe();
    this.current = scene;
    if (this.registry) scene.registry = this.registry;
    this.unsubscribe = this.watch(scene);
    this.openScripts(runsScripts);
    this.simulation.restart();
    this.selection.clear();
    this.assetSelection.clear();
    const library = previous.assets;
    previous.dispose();
    if (library !== scene.assets) library.dispose();
    this.watchAssets();
    this.opened.emit();
    this.assetsChanged.emit();
    this.prefabs.emit();
    this.structure.emit();
    this.microShaders.emit();
    this.edited.emit();
  }

  /**
   * Emits the name of a field of a component, of the scene's settings or of a material that changes, and without a name
   * when the component is switched on or off.
   */
  ownerSignal(owner: FieldOwner): OwnerSignal {
    let signal = this.ownerSignals.get(owner);
    if (!signal) this.ownerSignals.set(owner, (signal = new Signal()));
    return signal;
  }

  /** The scene as JSON text, in the file format. */
  serialize(): string {
    return `${JSON.stringify(serialize(this.scene), null, 1)}\n`;
  }

  private applied(command: Command, isDone: boolean): void {
    const { selection } = command;
    if (selection) this.selection.set(isDone ? selection.done : selection.undone);
    this.dropLost();
  }

  private tell(change: SceneChange): void {
    if (change.kind === 'field') this.ownerSignals.get(change.component)?.emit(change.field);
    else if (change.kind === 'enabled') this.ownerSignals.get(change.component)?.emit();
    else if (change.kind === 'settings') this.ownerSignals.get(this.scene.settings)?.emit(change.field);
    else if (change.kind === 'asset') {
      this.ownerSignals.get(change.asset)?.emit(change.field);
      this.materials.emit();
    } else if (change.kind === 'microshader') this.microShaders.emit();
    else if (change.kind === 'view') this.views.emit();
    else {
      if (change.kind === 'prefab' || (change.kind === 'object' && change.property === 'prefab')) this.prefabs.emit();
      this.structure.emit();
    }
    this.sceneChanged.emit(change);
    this.edited.emit();
  }

  private watch(scene: Scene): () => void {
    scene.onComponentError = (component, error) => this.onComponentError(component, error);
    return scene.onChange((change) => this.tell(change));
  }

  private openScripts(isOn: boolean): void {
    const { current: scene } = this;
    // classes of scripts belong to one scene, so they are not in a shared registry
    if (!this.registry)
      scene.registry = new ComponentRegistry(scene.registry.types.values(), {
        keepUnknown: scene.registry.keepsUnknown,
      });
    this.scripts.open(scene, scene.registry, isOn);
  }

  private watchAssets(): void {
    this.endAssets();
    this.endAssets = this.assets.onChange((change) => {
      if (change.kind === 'failed' && change.error && !this.toldElsewhere.has(change.name))
        this.onAssetFailed(change.error);
      // a changed value of a material is reported by the scene
      if (change.kind !== 'changed') this.assetsChanged.emit();
      if (change.kind === 'removed') this.dropLostAssets();
    });
  }

  /** Deselects assets that were removed. */
  private dropLostAssets(): void {
    const { items } = this.assetSelection;
    const found = items.filter((name) => this.assets.has(name) || this.scene.prefabs.get(name));
    if (found.length < items.length) this.assetSelection.set(found);
  }

  /** Deselects objects that were removed. */
  private dropLost(): void {
    const { ids } = this.selection;
    const found = ids.filter((id) => this.scene.findById(id));
    if (found.length < ids.length) this.selection.set(found);
  }
}
