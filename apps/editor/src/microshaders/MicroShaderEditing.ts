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

/** Takes chunks out of a registry; one may have to wait for another that depends on it. @returns those that are needed */
function takeOut(registry: MicroShaderRegistry, names: readonly string[]): string[] {
  let left = names.filter((name) => registry.has(name));
  for (let before = Infinity; left.length < before;) {
    before = left.length;
    left = left.filter((name) => {
      try {
        registry.remove(name);
        return false;
      } catch {
        return true;
      }
    });
  }
  return left;
}

/** Whether a chunk of a registry is of a surface. */
export const isOfSurface = (name: string): boolean => /^surface\/\d+(\/vertex)?$/.test(name);

/** What a new chunk begins with. */
const TEMPLATE = `// What it is for.
// Where it comes from.
`;

/**
 * The microshaders of the document as texts that are edited: what compiles is drawn with at once and becomes a step of
 * history; what does not stays a draft, and the picture keeps the last good text.
 */
export class MicroShaderEditing extends TextDrafts<string> {
  /** Texts of the built-in chunks as they were written; what is drawn with may have lost its comments. */
  sources: Readonly<Record<string, string>> = {};

  /** Chunks of plugins. */
  private readonly added: Readonly<Record<string, string>>[] = [];
  private readonly overrides: MicroShaderOverrides[];

  /** @param registry - of the renderer of the picture */
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

  /** Names of all chunks: the built-in ones, then the scene's own. */
  get names(): string[] {
    // surfaces are assets, see SurfaceEditing
    const all = [...this.registry.names(), ...this.document.scene.microShaders.texts.keys()];
    return [...new Set(all)].filter((name) => !isOfSurface(name));
  }

  /** Whether a chunk is the scene's own, not one that it replaces. */
  isOwn(name: string): boolean {
    return this.overrides[0].originalOf(name) === undefined;
  }

  /** Whether the scene has a text of its own for a chunk. */
  isChanged(name: string): boolean {
    return this.document.scene.microShaders.get(name) !== undefined;
  }

  /** Why the text of a chunk is not in use; null when it is. */
  problem(name: string): MicroShaderProblemText | null {
    return this.problems.get(name) ?? null;
  }

  /** The text of a chunk as it is being edited. */
  textOf(name: string): string {
    return this.drafts.get(name) ?? this.document.scene.microShaders.get(name) ?? this.originalOf(name);
  }

  /** The text of a built-in chunk as it is without the scene's; '' for the scene's own. */
  originalOf(name: string): string {
    const original = this.overrides[0].originalOf(name);
    if (!original) return '';
    return this.sources[name] ?? formatMicroShader(original);
  }

  /** A key was pressed: compiles the text once no more follow. */
  edit(name: string, text: string): void {
    this.type(name, text);
  }

  /** Drops a draft that does not compile. */
  discardDraft(name: string): void {
    this.flush();
    this.drop(name);
    this.changed.emit();
  }

  /** Takes the scene's text of a chunk out: the built-in one is back; one of the scene's own is gone. @throws Error when it is needed */
  revert(name: string): void {
    this.discardDraft(name);
    const users = this.isOwn(name) ? this.registry.usersOf(name).filter((other) => other !== name) : [];
    if (users.length > 0)
      throw new Error(t('“{name}” is needed by {users}: change those first.', { name, users: users.join(', ') }));
    const label = this.isOwn(name)
      ? t('Deleted microshader {name}', { name })
      : t('Reverted microshader {name}', { name });
    this.run(label, [{ name, text: null }]);
  }

  /** Adds a chunk of the scene's own. @throws Error for a name that is taken or cannot be */
  create(name: string): void {
    if (this.names.includes(name))
      throw new Error(t('There is a microshader “{name}” already: choose another name.', { name }));
    this.run(t('New microshader {name}', { name }), [{ name, text: TEMPLATE }]);
  }

  /** Takes texts into the scene as one step of history, in place of those of the same name. */
  takeOver(label: string, edits: readonly MicroShaderEdit[]): void {
    this.run(label, edits);
  }

  /** The chunks of the scene, or all when it has none, as they are in use. */
  exported(): MicroShader[] {
    const own = [...this.document.scene.microShaders.texts.keys()].toSorted();
    return (own.length > 0 ? own : this.names).flatMap((name) => this.registry.get(name) ?? []);
  }

  /** Has another renderer draw with the scene's microshaders too. @returns a function that ends it */
  addRegistry(registry: MicroShaderRegistry): () => void {
    for (const texts of this.added) for (const name of Object.keys(texts)) registry.loadGLSL(name, texts[name]);
    const overrides = new MicroShaderOverrides(registry);
    overrides.apply(this.document.scene.microShaders.texts);
    this.overrides.push(overrides);
    return () => this.overrides.splice(this.overrides.indexOf(overrides), 1);
  }

  /**
   * Adds chunks to every renderer of the editor, those of plugins.
   * @param texts - in the form of a `.glsl` file, by name
   * @returns a function that takes them out, and gives the names of those that stay, since something needs them
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

  /** Changes each registry while it holds nothing of the scene's. */
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

  /** Brings the scene's texts into the renderers: after an edit, an undo, or when another scene was opened. */
  private apply(): void {
    const { texts } = this.document.scene.microShaders;
    for (const overrides of this.overrides.slice(1)) overrides.apply(texts);
    for (const { name, error } of this.overrides[0].apply(texts)) {
      this.problems.set(name, problemOf(error));
      this.log.add('error', 'shader', error.message, { chunk: name, line: 1 });
    }
    // a draft of a text that came from elsewhere is out of date
    for (const name of this.drafts.keys())
      if (!this.isWaiting(name) && !this.problems.has(name)) this.drafts.delete(name);
    for (const name of this.problems.keys())
      if (!this.registry.has(name) && !texts.has(name)) this.problems.delete(name);
    this.changed.emit();
  }
}
