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

/** An error thrown by a component of a script while the scene played. */
export interface ScriptFailure extends ScriptPlace {
  /** Message of the error, without its place. */
  readonly message: string;
  /** Type of the component that threw. */
  readonly component: string;
  readonly object: string;
  /** Text of the script. */
  readonly source: unknown;
}

/**
 * Why scripts are off: they are untrusted (of a file, a link or a paste), the page hung when they last ran, the address
 * says `?scripts=off`, or the editor is in a frame of another page, which could trick the user into clicking.
 */
export type OffReason = 'foreign' | 'hung' | 'address' | 'framed';

const NONE: ReadonlyMap<string, never> = new Map<string, never>();

/** Modules that scripts can import; fetched with the first script. */
const loadModules = async (): Promise<SceneScriptsOptions> => ({
  modules: (await import('./scriptModules')).scriptModules,
  compile: compileScript,
  run: runInPage,
});

/**
 * The scripts of the document's scene: whether they run, and their errors. Nothing is compiled or fetched until the
 * scene has a script.
 */
export class DocumentScripts {
  /** Emits when a script is compiled, fails or is removed, when one throws, and when scripts are switched on or off. */
  readonly changed = new Signal();

  /** Why scripts are off, until the user decides whether they run; null when there is nothing to decide. */
  question: OffReason | null = null;

  private held: OffReason | null = null;
  private scene: Scene | null = null;
  private registry: ComponentRegistry | null = null;
  private current: SceneScripts | null = null;
  private isWanted = true;
  private failed: ReadonlyMap<string, ScriptFailure> = NONE;
  private endWatch: () => void = () => {};
  /** Pending while the script compiler and modules are being fetched. */
  private starting: Promise<void> | null = null;

  /** @param load - fetches the options for running scripts; the page's own when absent */
  constructor(private readonly load: () => Promise<SceneScriptsOptions> | SceneScriptsOptions = loadModules) {}

  /** Whether the scene's scripts run. Those of an untrusted scene are off until the user allows them. */
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

  /** Switches scripts off, in this scene and later ones, until the user allows them; `framed` cannot be allowed. */
  hold(reason: OffReason): void {
    this.isOn = false;
    this.held = this.question = reason;
    this.changed.emit();
  }

  /** Switches all scripts off until the user decides, since untrusted ones were added to this scene. */
  ask(): void {
    if (!this.isWanted) return;
    this.question = 'foreign';
    this.isOn = false;
  }

  /** Keeps scripts off, as the user decided; the question is not asked again for this scene. */
  keepOff(): void {
    this.question = null;
    this.changed.emit();
  }

  /** The types of a registry except those defined by scripts: each opened scene gets the types of its own scripts. */
  withoutScripts(registry: ComponentRegistry): ComponentRegistry {
    const others = [...registry.types.values()].filter((type) => this.current?.scriptOf(type) == null);
    return new ComponentRegistry(others, { keepUnknown: registry.keepsUnknown });
  }

  /** Scripts that do not compile or do not run as a module, by name: the error with its line and column. */
  get errors(): ReadonlyMap<string, ScriptError> {
    return this.current?.errors ?? NONE;
  }

  /** By script name, the last error that the script's present text threw since the scene began to play. */
  get failures(): ReadonlyMap<string, ScriptFailure> {
    return this.failed;
  }

  /** The component class that a script defines; null when it defines none or has not compiled. */
  classOf(script: string): ComponentClass | null {
    return this.current?.classOf(script) ?? null;
  }

  /** Name of the script that defines a component's class; null for other components. */
  scriptOf({ componentClass }: Component): string | null {
    return this.current?.scriptOf(componentClass) ?? null;
  }

  /** Whether a script is being compiled, or the compiler is being fetched. */
  get isCompiling(): boolean {
    return this.starting !== null || (this.current?.isCompiling ?? false);
  }

  /** Fulfilled when all scripts are compiled and run. */
  async settled(): Promise<void> {
    await this.starting;
    await this.current?.settled();
  }

  /** @internal Called when another scene was opened. @param isOn - whether its scripts run */
  open(scene: Scene, registry: ComponentRegistry, isOn: boolean): void {
    this.close();
    this.scene = scene;
    this.registry = registry;
    this.isWanted = isOn && this.held === null;
    this.question = this.held ?? (isOn ? null : 'foreign');
    this.endWatch = scene.assets.onChange((change) => {
      if ((change.kind !== 'registered' && change.kind !== 'removed') || change.type !== 'script') return;
      if (change.kind === 'registered') this.begin();
      // running scripts emit this themselves; while they are off, a script may have been added or removed
      if (!this.isWanted) this.changed.emit();
    });
    this.begin();
    this.changed.emit();
  }

  /** @internal Called before the scene is disposed of. */
  close(): void {
    this.endWatch();
    this.current?.dispose();
    this.current = null;
    this.starting = null;
    this.failed = NONE;
  }

  /** @internal Called when a component threw. @returns the failure when the component is of a script */
  note(component: Component, error: unknown): ScriptFailure | null {
    const script = this.scriptOf(component);
    if (script === null) return null;
    const place = this.current!.placeOf(error) ?? { script, line: 0, column: 0 };
    const failure: ScriptFailure = {
      ...place,
      message: error instanceof Error ? error.message : String(error),
      source: this.sourceOf(place.script),
      component: component.typeName,
      object: component.isAttached ? component.gameObject.name : '',
    };
    this.failed = new Map([...this.failed, [place.script, failure]]);
    this.changed.emit();
    return failure;
  }

  /** @internal Called when the scene begins to play. */
  forgetFailures(): void {
    if (this.failed.size === 0) return;
    this.failed = NONE;
    this.changed.emit();
  }

  private sourceOf(script: string): unknown {
    return this.scene?.assets.fieldAsset(script)?.get('source');
  }

  /** Runs the scene's scripts, once it has some. */
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
    this.current.onChange(() => {
      const kept = [...this.failed].filter(([script, { source }]) => source === this.sourceOf(script));
      if (kept.length < this.failed.size) this.failed = new Map(kept);
      this.changed.emit();
    });
    this.changed.emit();
  }
}
