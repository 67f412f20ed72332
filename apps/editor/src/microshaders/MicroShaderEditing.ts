import { t } from '@farol/editing';
import { MicroShaderOverrides } from '@farol/engine';
import {
  formatMicroShader,
  type MicroShader,
  type MicroShaderCompileEntry,
  type MicroShaderRegistry,
} from '@farol/renderer/microshaders';
import { type MicroShaderEdit, SetMicroShaders } from '../model/commands/SetMicroShaders';
import type { ConsoleLog } from '../model/ConsoleLog';
import type { EditorDocument } from '../model/EditorDocument';
import { type MicroShaderProblemText, problemOf, TextDrafts } from './TextDrafts';

/** Removes microshaders from a registry, dependents first. @returns those that stay, since others include them */
function takeOut(registry: MicroShaderRegistry, names: readonly string[]): string[] {
  let remaining = names.filter((name) => registry.has(name));
  for (let countBefore = Infinity; remaining.length < countBefore;) {
    countBefore = remaining.length;
    remaining = remaining.filter((name) => {
      try {
        registry.remove(name);
        return false;
      } catch {
        return true;
      }
    });
  }
  return remaining;
}

/** Whether a microshader of a registry was generated from a surface. */
export const isOfSurface = (name: string): boolean => /^surface\/\d+(\/vertex)?$/.test(name);

/** Text of a new microshader. */
const TEMPLATE = `// What it is for.
// Where it comes from.
`;

/**
 * Editing of the document's microshaders. A text that compiles is used at once and becomes a step of history; one that
 * does not stays a draft, while the viewport keeps the last valid text.
 */
export class MicroShaderEditing extends TextDrafts<string> {
  /** Original texts of the built-in microshaders; those in the registry may lack comments. */
  sources: Readonly<Record<string, string>> = {};

  /** Microshaders of plugins. */
  private readonly added: Readonly<Record<string, string>>[] = [];
  private readonly overrides: MicroShaderOverrides[];

  /** @param registry - registry of the viewport's renderer */
  constructor(
    private readonly document: EditorDocument,
    readonly registry: MicroShaderRegistry,
    log: ConsoleLog,
  ) {
    super(() => document.commands, log);
    this.overrides = [new MicroShaderOverrides(registry)];
    document.microShaders.subscribe(() => this.apply());
    document.opened.subscribe(() => this.forget());
  }

  /** Names of all microshaders: built-in ones, then the scene's own. */
  get names(): string[] {
    // texts of surfaces are assets, edited by SurfaceEditing
    const all = [...this.registry.names(), ...this.document.scene.microShaders.texts.keys()];
    return [...new Set(all)].filter((name) => !isOfSurface(name));
  }

  /** Whether a microshader exists only in the scene, rather than replacing a built-in one. */
  isOwn(name: string): boolean {
    return this.overrides[0].originalOf(name) === undefined;
  }

  /** Whether the scene has a text for a microshader. */
  isChanged(name: string): boolean {
    return this.document.scene.microShaders.get(name) !== undefined;
  }

  /** Why the text of a microshader is not in use; null when it is. */
  problem(name: string): MicroShaderProblemText | null {
    return this.problems.get(name) ?? null;
  }

  /** Text of a microshader, as last edited, even where it does not compile. */
  textOf(name: string): string {
    return this.drafts.get(name) ?? this.document.scene.microShaders.get(name) ?? this.originalOf(name);
  }

  /** The built-in text of a microshader, which the scene may replace; '' for one of the scene. */
  originalOf(name: string): string {
    const original = this.overrides[0].originalOf(name);
    if (!original) return '';
    return this.sources[name] ?? formatMicroShader(original);
  }

  /** Notes typed text, which is compiled once typing pauses. */
  edit(name: string, text: string): void {
    this.type(name, text);
  }

  /** Discards a draft that does not compile. */
  discardDraft(name: string): void {
    this.flush();
    this.drop(name);
    this.changed.emit();
  }

  /**
   * Removes the scene's text of a microshader: a built-in one gets its original text, another one is deleted. @throws
   * Error when other microshaders include it
   */
  revert(name: string): void {
    this.discardDraft(name);
    const users = this.isOwn(name) ? this.registry.usersOf(name).filter((other) => other !== name) : [];
    if (users.length > 0)
      throw new Error(t('“{name}” is included by {users}: change those first.', { name, users: users.join(', ') }));
    const label = this.isOwn(name)
      ? t('Deleted microshader {name}', { name })
      : t('Reverted microshader {name}', { name });
    this.run(label, [{ name, text: null }]);
  }

  /** Adds a microshader to the scene. @throws Error for a name that is taken or invalid */
  create(name: string): void {
    if (this.names.includes(name))
      throw new Error(t('A microshader “{name}” exists already: choose another name.', { name }));
    this.run(t('New microshader {name}', { name }), [{ name, text: TEMPLATE }]);
  }

  /** Sets texts of microshaders in the scene as one step of history. */
  takeOver(label: string, edits: readonly MicroShaderEdit[]): void {
    this.run(label, edits);
  }

  /** The texts in use of the scene's microshaders; of all microshaders when the scene has none. */
  exported(): MicroShader[] {
    const sceneNames = [...this.document.scene.microShaders.texts.keys()].toSorted();
    return (sceneNames.length > 0 ? sceneNames : this.names).flatMap((name) => this.registry.get(name) ?? []);
  }

  /** Uses the scene's microshaders in another renderer too. @returns a function that ends this */
  addRegistry(registry: MicroShaderRegistry): () => void {
    for (const texts of this.added) for (const name of Object.keys(texts)) registry.loadGLSL(name, texts[name]);
    const overrides = new MicroShaderOverrides(registry);
    overrides.apply(this.document.scene.microShaders.texts);
    this.overrides.push(overrides);
    return () => this.overrides.splice(this.overrides.indexOf(overrides), 1);
  }

  /**
   * Adds a plugin's microshaders to every renderer of the editor.
   * @param texts - texts in the form of `.glsl` files, by name
   * @returns a function that removes them, and returns the names of those that stay because others include them
   */
  addChunks(texts: Readonly<Record<string, string>>): () => string[] {
    const names = Object.keys(texts);
    this.withoutScene((registry) => {
      for (const name of names) registry.loadGLSL(name, texts[name]);
    });
    this.added.push(texts);
    return () => {
      this.added.splice(this.added.indexOf(texts), 1);
      const kept = new Set<string>();
      this.withoutScene((registry) => {
        for (const name of takeOut(registry, names)) kept.add(name);
      });
      return [...kept];
    };
  }

  /** Changes each registry while the scene's texts are removed from it. */
  private withoutScene(change: (registry: MicroShaderRegistry) => void): void {
    this.finish();
    for (const overrides of this.overrides) {
      overrides.apply(new Map());
      change(overrides.registry);
    }
    this.apply();
  }

  private run(label: string, edits: readonly MicroShaderEdit[]): void {
    this.finish();
    this.document.commands.run(new SetMicroShaders(label, this.document.scene, edits));
  }

  protected override compile(name: string, text: string): SetMicroShaders {
    const isOriginal = !this.isOwn(name) && text === this.originalOf(name);
    if (!isOriginal) this.overrides[0].replace(name, text);
    const label = t('Edited microshader {name}', { name });
    return new SetMicroShaders(label, this.document.scene, [{ name, text: isOriginal ? null : text }]);
  }

  protected override chunkOf(name: string): string {
    return name;
  }

  protected override chunkAt(name: string, { chunk }: MicroShaderCompileEntry): string {
    return chunk ?? name;
  }

  /** Updates the renderers to the scene's texts, after an edit, an undo, or when another scene was opened. */
  private apply(): void {
    const { texts } = this.document.scene.microShaders;
    for (const overrides of this.overrides.slice(1)) overrides.apply(texts);
    for (const { name, error } of this.overrides[0].apply(texts)) {
      this.problems.set(name, problemOf(error));
      this.log.add('error', 'shader', error.message, { chunk: name, line: 1 });
    }
    // drafts that are neither waiting nor broken are obsolete: their text was compiled, undone or replaced
    for (const name of this.drafts.keys())
      if (!this.isWaiting(name) && !this.problems.has(name)) this.drafts.delete(name);
    for (const name of this.problems.keys())
      if (!this.registry.has(name) && !texts.has(name)) this.problems.delete(name);
    this.changed.emit();
  }
}
