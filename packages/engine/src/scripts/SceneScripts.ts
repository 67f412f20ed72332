import { currentOf } from '@farol/editing';
import type { ScriptAsset } from '../assets/ScriptAsset';
import { Component } from '../core/Component';
import type { ComponentClass } from '../core/ComponentClass';
import type { ComponentRegistry } from '../core/ComponentRegistry';
import type { Scene } from '../core/Scene';
import { UnknownComponent } from '../core/UnknownComponent';
import type { CompiledScript, ScriptFunction, ScriptRunner } from './CompiledScript';
import { KeptValues } from './KeptValues';
import { asScriptError, type ScriptModule, ScriptModules } from './ScriptModules';
import { ScriptError, type ScriptPlace } from './ScriptError';
import { ScriptReset } from './ScriptReset';
import { scriptClass } from './scriptClass';
import { placeOfError } from './scriptUrl';

/** Options of the constructor of SceneScripts. */
export interface SceneScriptsOptions {
  /** Modules that scripts can import besides each other, by name: 'three', '@farol/engine', '@farol/engine/fields'. */
  readonly modules: Readonly<Record<string, object>>;
  /** Runner that makes a compiled script into its function; `runInPage`, or a substitute in tests. */
  readonly run: ScriptRunner;
  /** `compileScript`, or a function that returns precompiled scripts. */
  readonly compile: (name: string, source: string) => Promise<CompiledScript | ScriptError>;
  /** Whether the scene's scripts run; true when absent. */
  readonly isOn?: boolean;
}

/** Greatest number of texts per script whose functions are cached, as many as a history has steps. */
const KEPT_TEXTS = 1000;

/** State of one script asset, kept after its removal from the library, since undo brings the asset back. */
class Entry {
  /** Compiled function, or compile error, of each source text. */
  readonly results = new Map<string, ScriptFunction | ScriptError>();
  /**
   * For each text that could not be compiled, the function that ran before it; null for none. It runs again whenever
   * the text returns, for instance by undo.
   */
  private readonly lastGood = new Map<string, ScriptFunction | null>();
  /** Source text that is being compiled; null when none is. */
  pending: string | null = null;
  /** Function whose call made the running module; `name` is that module's name. */
  run: ScriptFunction | null = null;
  name = '';
  componentClass: ComponentClass | null = null;
  error: ScriptError | null = null;

  constructor(readonly asset: ScriptAsset) {}

  /** Compiled function of the script's present text, or of the last text that could be compiled. */
  get newest(): ScriptFunction | null {
    const { source } = this.asset;
    const result = this.results.get(source);
    if (typeof result === 'function') return result;
    return result === undefined ? this.run : this.lastGood.get(source)!;
  }

  /** Compile error of the present text; null for none. */
  get resultError(): ScriptError | null {
    const result = this.results.get(this.asset.source);
    return result instanceof ScriptError ? result : null;
  }

  get isWaiting(): boolean {
    return !this.results.has(this.asset.source) && !this.run;
  }

  keep(source: string, result: ScriptFunction | ScriptError): void {
    this.results.set(source, result);
    if (typeof result !== 'function') this.lastGood.set(source, this.run);
    if (this.results.size <= KEPT_TEXTS) return;
    const [oldest] = this.results.keys();
    this.results.delete(oldest);
    this.lastGood.delete(oldest);
  }
}

/**
 * The scripts of a scene: compiles them, runs them as modules, and registers their classes. When a script changes, its
 * components are replaced by ones of the new class with the same field values; a broken script leaves the last good
 * class in use. Without their script, or while scripts are off, components are kept as data.
 */
export class SceneScripts {
  private readonly entries = new Map<ScriptAsset, Entry>();
  private readonly modules: ScriptModules;
  private readonly values = new KeptValues();
  private readonly entryOf = new WeakMap<ComponentClass, Entry>();
  /** Function of the script text that each class comes from. */
  private readonly runOf = new WeakMap<ComponentClass, ScriptFunction>();
  private readonly listeners = new Set<() => void>();
  private readonly endings: (() => void)[];
  private readonly waiting: (() => void)[] = [];
  private running: boolean;
  private isDisposed = false;
  private errorsByName: ReadonlyMap<string, ScriptError> = new Map();

  constructor(
    private readonly scene: Scene,
    private readonly registry: ComponentRegistry,
    private readonly options: SceneScriptsOptions,
  ) {
    this.running = options.isOn ?? true;
    // `__esModule` keeps compiled `import * as` from wrapping the host's modules
    const given = Object.entries(options.modules).map(
      ([name, module]) => [name, { ...module, __esModule: true }] as const,
    );
    this.modules = new ScriptModules(
      (name) => this.functionOf(name),
      (name) => this.listed.some((asset) => asset.name === name),
      new Map(given),
    );
    const system = scene.system(ScriptReset);
    system.onReset = () => this.restart();
    this.endings = [
      scene.assets.onChange((change) => {
        const { kind } = change;
        if (kind !== 'registered' && kind !== 'removed' && kind !== 'changed') return;
        if (change.type === 'script') this.refresh();
      }),
      scene.onChange((change) => {
        if (change.kind === 'add') change.gameObject.traverse((object) => this.update(object.components));
        else if (change.kind === 'component-add') this.update([change.component]);
      }),
      () => (system.onReset = null),
    ];
    this.refresh();
  }

  /** Whether the scene's scripts run. */
  get isOn(): boolean {
    return this.running;
  }

  /** Runs the scripts, or keeps their components as data. */
  set isOn(value: boolean) {
    if (value === this.running) return;
    this.running = value;
    this.refresh();
  }

  /** Error of each broken script, by name; a new map after each change. */
  get errors(): ReadonlyMap<string, ScriptError> {
    return this.errorsByName;
  }

  /** Whether a script is being compiled. */
  get isCompiling(): boolean {
    return [...this.entries.values()].some(({ pending }) => pending !== null);
  }

  /**
   * Running class of a script, by the asset's name; null for a script without a default export, or one that has never
   * compiled.
   */
  classOf(name: string): ComponentClass | null {
    const asset = this.scene.assets.fieldAsset(name);
    return asset?.type === 'script' ? (this.entries.get(asset as ScriptAsset)?.componentClass ?? null) : null;
  }

  /** The name of the script that a class of components comes from; null for others. */
  scriptOf(type: ComponentClass): string | null {
    return this.entryOf.get(type)?.asset.name ?? null;
  }

  /** Script and line that threw an error; null when thrown elsewhere. */
  placeOf(error: unknown): ScriptPlace | null {
    return placeOfError(
      error,
      this.listed.map(({ name }) => name),
    );
  }

  /**
   * Calls `listener` when a script is compiled, fails or is removed, and when scripts are switched on or off.
   * @returns a function that removes the listener
   */
  onChange(listener: () => void): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  /** Resolves when no script is being compiled. */
  settled(): Promise<void> {
    return this.isCompiling ? new Promise((resolve) => this.waiting.push(resolve)) : Promise.resolve();
  }

  /** Runs all scripts again, with new modules and components. */
  restart(): void {
    if (this.running && this.scene.isSimulated) this.apply(true);
  }

  /** Removes the scripts' classes from the registry. Components keep their classes. */
  dispose(): void {
    this.isDisposed = true;
    for (const end of this.endings) end();
    for (const { componentClass } of this.entries.values()) {
      if (componentClass) this.registry.unregister(componentClass);
    }
    this.listeners.clear();
    for (const resolve of this.waiting.splice(0)) resolve();
  }

  private get listed(): ScriptAsset[] {
    return this.scene.assets.fieldAssets('script') as ScriptAsset[];
  }

  private entry(asset: ScriptAsset): Entry {
    let entry = this.entries.get(asset);
    if (!entry) this.entries.set(asset, (entry = new Entry(asset)));
    return entry;
  }

  private functionOf(name: string): ScriptFunction | null {
    const asset = this.listed.find((each) => each.name === name);
    if (!asset) return null;
    const entry = this.entry(asset);
    const { newest } = entry;
    if (newest) return newest;
    throw entry.resultError ?? new ScriptError(name, 'it is still being loaded: wait for it.');
  }

  /** Compiles new texts, and updates the scene once all are compiled. */
  private refresh(): void {
    if (this.isDisposed) return;
    const entries = this.listed.map((asset) => this.entry(asset));
    if (this.running) {
      for (const entry of entries) {
        if (entry.pending === null && !entry.results.has(entry.asset.source)) void this.compile(entry);
      }
      // scripts may import each other: none runs until all texts are compiled
      if (entries.some(({ isWaiting }) => isWaiting)) return this.tell();
    }
    this.apply();
  }

  private async compile(entry: Entry): Promise<void> {
    const { name, source } = entry.asset;
    entry.pending = source;
    let result: ScriptFunction | ScriptError;
    try {
      const compiled = await this.options.compile(name, source);
      result = compiled instanceof ScriptError ? compiled : await this.options.run(compiled);
    } catch (error) {
      result = asScriptError(error, name);
    }
    entry.pending = null;
    entry.keep(source, result);
    this.refresh();
    if (!this.isCompiling) for (const resolve of this.waiting.splice(0)) resolve();
  }

  /**
   * Runs changed scripts, and those that import them, and updates the classes of components.
   * @param isAll - runs all scripts
   */
  private apply(isAll = false): void {
    const { modules } = this;
    const listed = new Set(this.running ? this.listed.map((asset) => this.entry(asset)) : []);
    const stale = new Set<Entry>();
    const names = new Set<string>();
    for (const entry of this.entries.values()) {
      const { asset, run } = entry;
      const isSame = listed.has(entry) && run !== null && run === entry.newest && entry.name === asset.name;
      entry.error = entry.resultError;
      if (listed.has(entry) ? isSame && !isAll : run === null) continue;
      stale.add(entry);
      if (entry.name) names.add(entry.name);
      names.add(entry.asset.name);
    }
    const affected = modules.dependentsOf(names);
    for (const entry of listed) if (affected.has(entry.asset.name)) stale.add(entry);
    const before = new Map<Entry, ScriptModule | undefined>();
    for (const entry of stale) before.set(entry, modules.get(entry.name));
    for (const name of affected) modules.forget(name);
    for (const entry of stale) {
      if (listed.has(entry)) continue;
      this.setClass(entry, null);
      Object.assign(entry, { run: null, name: '', error: null });
    }
    for (const entry of stale) if (listed.has(entry)) this.runOne(entry, before.get(entry));
    if (stale.size > 0) {
      const components: Component[] = [];
      this.scene.traverse((object) => components.push(...object.components));
      this.update(components);
      for (const each of components) this.followReplaced(currentOf(each));
    }
    this.errorsByName = new Map([...listed].flatMap(({ asset, error }) => (error ? [[asset.name, error]] : [])));
    this.tell();
  }

  private runOne(entry: Entry, before: ScriptModule | undefined): void {
    const { name, source } = entry.asset;
    const { newest } = entry;
    if (!newest) {
      // never compiled: another script's text may have run under this name meanwhile
      this.setClass(entry, null);
      Object.assign(entry, { run: null, name: '' });
      return;
    }
    try {
      const module = this.modules.load(name);
      const type = scriptClass(module, source, entry.componentClass !== null);
      if (type) this.checkFree(type, entry);
      this.setClass(entry, type);
      if (type) this.runOf.set(type, newest);
      entry.run = newest;
      entry.name = name;
    } catch (error) {
      entry.error ??= asScriptError(error, name);
      if (before && before.name === name) this.modules.restore(before);
      else this.modules.forget(name);
    }
  }

  private checkFree({ typeName }: ComponentClass, entry: Entry): void {
    const known = this.registry.types.get(typeName);
    if (!known || known === entry.componentClass) return;
    const other = this.entryOf.get(known);
    const owner = other ? `the script ${other.asset.name}` : 'Farol or a plugin';
    throw new ScriptError(
      entry.asset.name,
      `there is a component '${typeName}' of ${owner} already: give the script another name, or its class another typeName.`,
    );
  }

  private setClass(entry: Entry, type: ComponentClass | null): void {
    if (entry.componentClass === type) return;
    if (entry.componentClass) this.registry.unregister(entry.componentClass);
    entry.componentClass = type;
    if (!type) return;
    this.registry.register(type);
    this.entryOf.set(type, entry);
  }

  /** Replaces components of a script's earlier class by ones of its present class. */
  private update(components: readonly Component[]): void {
    for (const component of components) {
      const { componentClass, typeName } = component;
      const entry = this.entryOf.get(componentClass);
      if (entry) {
        if (entry.componentClass !== componentClass) this.change(component, entry.componentClass);
      } else if (component instanceof UnknownComponent) {
        const known = this.registry.types.get(typeName);
        if (known && this.entryOf.has(known)) this.change(component, known);
      }
    }
  }

  /** Replaces references to replaced components, in properties and arrays of a script's component. */
  private followReplaced(component: Component): void {
    if (!this.entryOf.has(component.componentClass)) return;
    for (const holder of [component, ...Object.values(component).filter(Array.isArray)])
      for (const [key, value] of Object.entries(holder))
        if (value instanceof Component) Reflect.set(holder, key, currentOf(value));
  }

  private change(component: Component, type: ComponentClass | null): void {
    const { runOf } = this;
    const origin = type && (runOf.get(type) ?? null);
    this.values.change(component, type, runOf.get(component.componentClass) ?? null, origin);
  }

  private tell(): void {
    for (const listener of this.listeners) listener();
  }
}
