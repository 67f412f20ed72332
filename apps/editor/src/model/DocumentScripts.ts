import { Signal } from '@farol/editing';
import { type Component, type ComponentClass, ComponentRegistry, type Scene } from '@farol/engine';
import {
  compileScript,
  runInPage,
  SceneScripts,
  type SceneScriptsOptions,
  type ScriptError,
  type ScriptPlace,
} from '@farol/engine/scripts';

/** Something that a component of a script threw while the scene played. */
export interface ScriptFailure extends ScriptPlace {
  /** What was thrown, without the place. */
  readonly message: string;
  /** Type of the component, and the name of its object. */
  readonly component: string;
  readonly object: string;
}

/**
 * Why scripts are off: they came from elsewhere, the page hung when they ran last, the address says `?scripts=off`, or the
 * editor is in a frame of another page, which could lead the user's clicks.
 */
export type OffReason = 'foreign' | 'hung' | 'address' | 'framed';

const NONE: ReadonlyMap<string, never> = new Map<string, never>();

/** Modules that scripts can import, fetched when the first script comes. */
const loadModules = async (): Promise<SceneScriptsOptions> => ({
  modules: (await import('./scriptModules')).scriptModules,
  compile: compileScript,
  run: runInPage,
});

/**
 * The scripts of the document's scene: whether they run, and what is wrong with them. Nothing is compiled, nor fetched for it,
 * before the scene has a script.
 */
export class DocumentScripts {
  /** Emits when a script is compiled, fails or goes, when one throws, and when scripts are switched on or off. */
  readonly changed = new Signal();

  /** Why scripts are off, until the user has answered whether they shall run; null when nothing is to be asked. */
  question: OffReason | null = null;

  private held: OffReason | null = null;
  private scene: Scene | null = null;
  private registry: ComponentRegistry | null = null;
  private current: SceneScripts | null = null;
  private isWanted = true;
  private failed: ReadonlyMap<string, ScriptFailure> = NONE;
  private endWatch: () => void = () => {};
  /** While what scripts need is being fetched. */
  private starting: Promise<void> | null = null;

  /** @param load - what scripts get and how they are run; the page's own when absent */
  constructor(private readonly load: () => Promise<SceneScriptsOptions> | SceneScriptsOptions = loadModules) {}

  /** Whether scripts of the scene run. A scene of somebody else's has them off until the user says so. */
  get isOn(): boolean {
    return this.isWanted;
  }

  set isOn(value: boolean) {
    if (value === this.isWanted || this.held === 'framed') return;
    this.isWanted = value;
    if (value) this.question = this.held = null;
    if (this.current) this.current.isOn = value;
    else this.begin();
    this.changed.emit();
  }

  /** Whether the scene has scripts. */
  get areThere(): boolean {
    return (this.scene?.assets.fieldAssets('script').length ?? 0) > 0;
  }

  /** Has scripts off in this scene and those that are opened next, until the user switches them on; framed ones for good. */
  hold(reason: OffReason): void {
    this.isOn = false;
    this.held = this.question = reason;
    this.changed.emit();
  }

  /** Scripts come from elsewhere into this scene: all of its are off until the user has said whether they shall run. */
  ask(): void {
    if (!this.isWanted) return;
    this.question = 'foreign';
    this.isOn = false;
  }

  /** The user wants scripts to stay off: it is not asked again for this scene. */
  keepOff(): void {
    this.question = null;
    this.changed.emit();
  }

  /** The types of a registry without those of scripts: scenes that are opened have scripts of their own. */
  withoutScripts(registry: ComponentRegistry): ComponentRegistry {
    const others = [...registry.types.values()].filter((type) => this.current?.scriptOf(type) == null);
    return new ComponentRegistry(others, { keepUnknown: registry.keepsUnknown });
  }

  /** What cannot be compiled or run as a module, by the name of the script: syntax errors and others, with line and column. */
  get errors(): ReadonlyMap<string, ScriptError> {
    return this.current?.errors ?? NONE;
  }

  /** What scripts threw last since the scene began to play, by the name of the script. */
  get failures(): ReadonlyMap<string, ScriptFailure> {
    return this.failed;
  }

  /** The class of components that a script has made; null while there is none. */
  classOf(script: string): ComponentClass | null {
    return this.current?.classOf(script) ?? null;
  }

  /** The script that a component is of; null for others. */
  scriptOf({ componentClass }: Component): string | null {
    return this.current?.scriptOf(componentClass) ?? null;
  }

  /** Whether a script is being compiled, or what scripts need is being fetched. */
  get isCompiling(): boolean {
    return this.starting !== null || (this.current?.isCompiling ?? false);
  }

  /** Fulfilled when what there is of scripts is compiled and runs. */
  async settled(): Promise<void> {
    await this.starting;
    await this.current?.settled();
  }

  /** @internal Another scene came. @param isOn - whether its scripts run */
  open(scene: Scene, registry: ComponentRegistry, isOn: boolean): void {
    this.close();
    this.scene = scene;
    this.registry = registry;
    this.isWanted = isOn && this.held === null;
    this.question = this.held ?? (isOn ? null : 'foreign');
    this.endWatch = scene.assets.onChange((change) => {
      if ((change.kind !== 'registered' && change.kind !== 'removed') || change.type !== 'script') return;
      if (change.kind === 'registered') this.begin();
      // what runs tells of it; while scripts are off, whether there are some may have changed
      if (!this.isWanted) this.changed.emit();
    });
    this.begin();
    this.changed.emit();
  }

  /** @internal Before the scene is disposed of. */
  close(): void {
    this.endWatch();
    this.current?.dispose();
    this.current = null;
    this.starting = null;
    this.failed = NONE;
  }

  /** @internal A component threw. @returns what is known of it when it is of a script */
  note(component: Component, error: unknown): ScriptFailure | null {
    const script = this.scriptOf(component);
    if (script === null) return null;
    const place = this.current!.placeOf(error) ?? { script, line: 0, column: 0 };
    const failure: ScriptFailure = {
      ...place,
      message: error instanceof Error ? error.message : String(error),
      component: component.typeName,
      object: component.isAttached ? component.gameObject.name : '',
    };
    this.failed = new Map([...this.failed, [place.script, failure]]);
    this.changed.emit();
    return failure;
  }

  /** @internal The scene begins to play, or stops. */
  forgetFailures(): void {
    if (this.failed.size === 0) return;
    this.failed = NONE;
    this.changed.emit();
  }

  /** Runs the scripts of the scene, once it has some. */
  private begin(): void {
    const { scene } = this;
    if (!scene || this.current || this.starting || !this.isWanted) return;
    if (scene.assets.fieldAssets('script').length === 0) return;
    const given = this.load();
    if (!(given instanceof Promise)) return this.start(given);
    this.starting = given.then((options) => {
      this.starting = null;
      if (this.scene === scene && !this.current) this.start(options);
    });
  }

  private start(options: SceneScriptsOptions): void {
    this.current = new SceneScripts(this.scene!, this.registry!, { ...options, isOn: this.isWanted });
    this.current.onChange(() => this.changed.emit());
    this.changed.emit();
  }
}
