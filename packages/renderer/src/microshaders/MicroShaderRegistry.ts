import { composeHeaders, composeStage } from './composeSource';
import { dependencyOrder, type MicroShaderSource } from './dependencyOrder';
import type { MicroShader } from './MicroShader';
import { completeMicroShader, parseMicroShader } from './parseMicroShader';
import type { MicroShaderCompiler, Shader } from './Shader';
import { ShaderCache } from './ShaderCache';
import { shortText } from './shortText';
import { hashText } from './hashText';

/** Options of the constructor of MicroShaderRegistry. */
export interface MicroShaderRegistryOptions<Program> {
  /** Compiles the programs of `getShader`, whose `program` is null without a compiler. */
  compiler?: MicroShaderCompiler<Program>;
}

/** Listener, called with the name of a replaced chunk and those of all chunks that depend on it. */
export type MicroShaderListener = (names: readonly string[]) => void;

/**
 * Microshaders by name: composes, compiles and caches shaders, and replaces chunks while shaders run.
 * @see thesis 3.1.2 and 3.2.6
 */
export class MicroShaderRegistry<Program = WebGLProgram> implements MicroShaderSource {
  private readonly ownChunks = new Map<string, MicroShader>();
  private readonly files = new Map<string, Promise<readonly string[]>>();
  private readonly shaders: ShaderCache<Program>;
  private readonly listeners = new Set<MicroShaderListener>();
  private readonly checks = new Set<MicroShaderListener>();
  /** Chunks set by `replace` or `swap`, by name; undefined: the parent's is restored. */
  private readonly edited = new Map<string, MicroShader | undefined>();
  private readonly swapped = new Map<string, MicroShader>();
  private replacements = 0;
  /** Revision at each chunk's last replacement; and, cached, the latest revision among a list of chunks and dependencies. */
  private readonly replacedAt = new Map<string, number>();
  private readonly revisions = new WeakMap<readonly string[], { at: number; revision: number }>();
  private readonly textKeys = new WeakMap<readonly string[], { revision: number; key: string }>();

  /** @param parent - registry with further chunks, which must not change */
  constructor(
    private readonly parent: MicroShaderSource | null = null,
    options: MicroShaderRegistryOptions<Program> = {},
  ) {
    this.shaders = new ShaderCache((vertex, fragment) => this.compose(vertex, fragment), options.compiler);
  }

  get(name: string): MicroShader | undefined {
    return this.ownChunks.get(name) ?? this.parent?.get(name);
  }

  has(name: string): boolean {
    return this.get(name) !== undefined;
  }

  /** All names, the parent's first. */
  names(): string[] {
    return [...new Set([...(this.parent?.names() ?? []), ...this.ownChunks.keys()])];
  }

  /** Adds chunks. @throws Error when a name is known already or not allowed; then none is added */
  add(chunks: MicroShader | readonly MicroShader[]): void {
    const added = ([] as MicroShader[]).concat(chunks).map(completeMicroShader);
    const names = new Set<string>();
    for (const { name } of added) {
      if (this.has(name) || names.has(name)) {
        throw new Error(
          `Microshader "${shortText(name)}" exists already; use replace() to change it, or give it another name.`,
        );
      }
      names.add(name);
    }
    for (const chunk of added) this.ownChunks.set(chunk.name, chunk);
  }

  /**
   * Adds one chunk from the text of a `.glsl` file, in the form of `parseMicroShader`.
   * @param isEdit - whether the text edits a chunk that late code adds later; `remove` then restores that chunk
   */
  loadGLSL(name: string, text: string, isEdit = false): void {
    this.add(parseMicroShader(name, text));
    if (!isEdit) return;
    this.edited.set(name, undefined);
    this.replacedAt.set(name, ++this.replacements);
  }

  /** Whether a chunk is an edit of one that late code has not added yet. */
  isEarly(name: string): boolean {
    return this.edited.has(name) && !this.edited.get(name) && !this.original(name);
  }

  /**
   * Adds the chunks of the thesis's XML, in the form of `parseMicroShaderXML` of `@farol/renderer/authoring`; the parser is late
   * code.
   * @param file - name of the file, for errors
   * @returns names of the chunks
   * @throws Error with file, and line where it has one; then none is added
   */
  async loadXML(text: string, file = 'microshaders'): Promise<readonly string[]> {
    return (await import('./xml/loadXML')).loadXML(this, text, file);
  }

  /** Fetches an XML file and adds its chunks, once: later calls return the same promise, unless loading failed. */
  loadXMLFile(url: string): Promise<readonly string[]> {
    let names = this.files.get(url);
    if (names === undefined) {
      names = import('./xml/loadXML').then((code) => code.fetchXML(this, url));
      this.files.set(url, names);
      names.catch(() => this.files.delete(url));
    }
    return names;
  }

  /**
   * Headers of these chunks and all their dependencies, each once, dependencies first, each between lines `// <name>` and
   * `// </name>`.
   * @throws Error for unknown names and cycles, with the path (`a -> b -> a`)
   */
  header(names: readonly string[]): string {
    return composeHeaders(names, this);
  }

  /** Whole shaders: the headers of `header`, then `main()` with the main parts in the order of the lists. */
  compose(
    vertexChunks: readonly string[],
    fragmentChunks: readonly string[],
  ): { vertexShader: string; fragmentShader: string } {
    return {
      vertexShader: composeStage(vertexChunks, this, 'vertex'),
      fragmentShader: composeStage(fragmentChunks, this, 'fragment'),
    };
  }

  /**
   * The shader of this name, composed and compiled by the first call; later calls return the same object.
   * @param xmlUrl - file to load when a chunk is unknown: only then is a promise returned, so `await` the result
   * @throws Error when the name belongs to other chunks already; MicroShaderCompileError when it does not compile
   */
  getShader(name: string, vertexChunks: readonly string[], fragmentChunks: readonly string[]): Shader<Program>;
  getShader(
    name: string,
    vertexChunks: readonly string[],
    fragmentChunks: readonly string[],
    xmlUrl: string | undefined,
  ): Shader<Program> | Promise<Shader<Program>>;
  getShader(
    name: string,
    vertexChunks: readonly string[],
    fragmentChunks: readonly string[],
    xmlUrl?: string,
  ): Shader<Program> | Promise<Shader<Program>> {
    const shader = () => this.shaders.get(name, vertexChunks, fragmentChunks);
    const known = [...this.withDependencies([...vertexChunks, ...fragmentChunks])].every((chunk) => this.has(chunk));
    return known || xmlUrl === undefined ? shader() : this.loadXMLFile(xmlUrl).then(shader);
  }

  /** Unedited chunk of a name: the parent's, or one that late code added after its edit; undefined when there is none. */
  original(name: string): MicroShader | undefined {
    return this.parent?.get(name) ?? (this.edited.has(name) ? this.swapped.get(name) : undefined);
  }

  /**
   * Replaces a known chunk. All shaders that use the chunk, directly or indirectly, are recompiled, and the checks run; if any
   * of this fails, nothing changes and the error is thrown.
   * @param content - text of a `.glsl` file, or a chunk of the same name
   * @throws MicroShaderCompileError with chunk and line; Error for unknown names and cycles; errors of checks
   */
  replace(name: string, content: string | MicroShader): void {
    const chunk = typeof content === 'string' ? parseMicroShader(name, content) : completeMicroShader(content);
    if (chunk.name !== name)
      throw new Error(`Microshader "${name}" cannot be replaced by one named "${chunk.name}"; give both one name.`);
    dependencyOrder([name], this);
    const before = this.edited.has(name) ? this.edited.get(name) : this.ownChunks.get(name);
    this.replaceChunk(name, chunk);
    if (content === (this.swapped.get(name) ?? before)) this.edited.delete(name);
    else this.edited.set(name, before);
  }

  /**
   * Removes a chunk added to this registry, or restores the parent's; like `replace`, changes nothing if it fails.
   * @throws Error when the registry has no such chunk of its own, or another chunk or a shader needs it
   */
  remove(name: string): void {
    const before = this.swapped.get(name);
    if (!this.ownChunks.has(name) || (before && !this.edited.has(name)))
      throw new Error(`Microshader "${name}" was not replaced; restore one that was.`);
    const user = before || this.original(name) ? undefined : this.usersOf(name).find((other) => other !== name);
    if (user) throw new Error(`Microshader "${name}" is included by "${user}"; change that one first.`);
    this.replaceChunk(name, before);
    this.edited.delete(name);
  }

  /** A chunk's name, then those of all that depend on it, directly or indirectly. */
  usersOf(name: string): string[] {
    const names = this.names();
    const users = new Set([name]);
    for (let known = 0; known < users.size;) {
      known = users.size;
      for (const other of names) if (this.get(other)!.dependencies.some((each) => users.has(each))) users.add(other);
    }
    return [...users];
  }

  /**
   * Replaces a chunk by the content of another that is known to compile; for an edited chunk, once the edit is undone. Programs
   * that use the chunk are recompiled at their next draw. No check runs.
   */
  swap(name: string, other: string | MicroShader): void {
    const content = typeof other === 'string' ? this.get(other) : other;
    if (content === undefined) return;
    const chunk = { ...content, name };
    this.swapped.set(name, chunk);
    if (this.edited.has(name)) return;
    this.ownChunks.set(name, chunk);
    const affected = this.usersOf(name);
    this.replacedAt.set(name, ++this.replacements);
    for (const listener of [...this.listeners]) listener(affected);
  }

  /** Number that grows whenever one of the named chunks, or a dependency of one, is replaced; 0 at first. */
  revision(names: readonly string[]): number {
    const { replacements: at } = this;
    if (at === 0) return 0;
    // cached, since it is read at each draw
    let known = this.revisions.get(names);
    if (known?.at !== at) {
      const all = [...this.withDependencies(names)];
      known = { at, revision: Math.max(0, ...all.map((used) => this.replacedAt.get(used) ?? 0)) };
      this.revisions.set(names, known);
    }
    return known.revision;
  }

  /**
   * Key of the texts of these chunks; empty while none of them is replaced. Differs for different texts, since a WebGLRenderer,
   * which registries may share, shares programs by key.
   */
  textKey(names: readonly string[]): string {
    const revision = this.revision(names);
    if (revision === 0) return '';
    let known = this.textKeys.get(names);
    if (known?.revision !== revision) {
      known = { revision, key: hashText(this.header(names)) };
      this.textKeys.set(names, known);
    }
    return known.key;
  }

  /** Adds a listener, called after each replacement. @returns function that removes it */
  onChange(listener: MicroShaderListener): () => void {
    this.listeners.add(listener);
    return () => void this.listeners.delete(listener);
  }

  /**
   * Adds a check, called before each replacement takes effect, when `header` and `compose` already return the new text: a check
   * that throws (its program does not compile) prevents the replacement.
   * @returns function that removes it
   */
  addCheck(check: MicroShaderListener): () => void {
    this.checks.add(check);
    return () => void this.checks.delete(check);
  }

  /** Recompiles all shaders of `getShader`, after a lost context is restored. */
  recompile(): void {
    this.shaders.recompile(() => true).commit();
  }

  /** Frees all programs of `getShader`; keeps the chunks. */
  dispose(): void {
    this.shaders.dispose();
  }

  /** @param chunk - the new chunk; undefined restores the parent's, or none */
  private replaceChunk(name: string, chunk: MicroShader | undefined): void {
    const before = this.ownChunks.get(name);
    const set = (value: MicroShader | undefined) =>
      void (value ? this.ownChunks.set(name, value) : this.ownChunks.delete(name));
    const affected = this.usersOf(name);
    set(chunk);
    try {
      if (this.has(name)) dependencyOrder([name], this);
      const recompiled = this.shaders.recompile((chunks) => chunks.some((used) => affected.includes(used)));
      try {
        for (const check of this.checks) check(affected);
      } catch (error) {
        recompiled.drop();
        throw error;
      }
      recompiled.commit();
    } catch (error) {
      set(before);
      throw error;
    }
    this.replacedAt.set(name, ++this.replacements);
    for (const listener of [...this.listeners]) listener(affected);
  }

  /** The names and those of all dependencies, of unknown names and cycles too. */
  private withDependencies(names: readonly string[]): Set<string> {
    const all = new Set(names);
    // iterating a set also visits names added meanwhile
    for (const name of all) for (const dependency of this.get(name)?.dependencies ?? []) all.add(dependency);
    return all;
  }
}
