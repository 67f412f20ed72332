import { Signal } from '@farol/editing';
import type { FarolRenderer, TechniqueName, View } from '@farol/renderer';
import { formatMicroShader } from '@farol/renderer/microshaders';
import { chunksOf, dryRun } from './dryRun';
import { isOfSurface } from './MicroShaderEditing';
import { probeMicroShader } from './probeMicroShader';

/** Views that draw with chunks of their own. */
export const VIEWS: readonly View[] = ['grid', 'lighting', 'light-count', 'overdraw'];

interface Program {
  readonly name: string;
  readonly vertexShader: WebGLShader;
  readonly fragmentShader: WebGLShader;
}

/** Where each microshader is used: by which techniques and views, and in which programs that are on the device now. */
export class MicroShaderUses {
  /** Emits when more is known. */
  readonly changed = new Signal();

  private readonly byTechnique = new Map<TechniqueName, ReadonlySet<string>>();
  private readonly byView = new Map<View, ReadonlySet<string>>();
  private search: Promise<void> | null = null;

  /**
   * @param farol - draws the picture
   * @param getTexts - the microshaders of the scene
   */
  constructor(
    private readonly farol: FarolRenderer,
    private readonly getTexts: () => ReadonlyMap<string, string>,
  ) {
    // a chunk that is in no program would be seen broken only when somebody draws with it
    farol.microshaders.addCheck((all) => {
      // surfaces have a check of their own
      const names = all.filter((name) => !isOfSurface(name));
      if (names.length === 0) return;
      const live = this.liveChunks();
      if (!names.some((name) => live.has(name))) this.probe(names);
    });
  }

  private get gl(): WebGL2RenderingContext {
    return this.farol.webgl.getContext() as WebGL2RenderingContext;
  }

  /** The techniques that can draw with something: all but 'auto', which draws by another one. */
  private get techniques(): TechniqueName[] {
    return (Object.keys(this.farol.techniques) as TechniqueName[]).filter((name) => name !== 'auto');
  }

  /**
   * Finds what each technique and view draws with, one after the other, without holding up the page. What is known is not
   * looked for again: a technique that was added since is.
   */
  find(): Promise<void> {
    if (this.isKnown) return Promise.resolve();
    // whoever is told may ask for more at once: a plugin may have added a technique meanwhile
    this.search ??= this.findAll()
      .finally(() => (this.search = null))
      .then(() => this.changed.emit());
    return this.search;
  }

  /** Whether everything is known. */
  get isKnown(): boolean {
    return this.byView.size === VIEWS.length && this.techniques.every((name) => this.byTechnique.has(name));
  }

  /** Techniques that draw with a chunk, 'auto' left out. */
  techniquesOf(name: string): TechniqueName[] {
    return this.drawn.filter(([, chunks]) => chunks.has(name)).map(([technique]) => technique);
  }

  /** Views, besides the final picture, that draw with a chunk. */
  viewsOf(name: string): View[] {
    const common = this.techniquesOf(name).length === this.drawn.length;
    return common ? [] : [...this.byView].filter(([, chunks]) => chunks.has(name)).map(([view]) => view);
  }

  /** Names of the programs on the device that hold a chunk. */
  programsOf(name: string): string[] {
    return this.programs()
      .filter(({ chunks }) => chunks.has(name))
      .map((program) => program.name);
  }

  /** What each technique draws with, as far as that is known; those that were removed since are left out. */
  private get drawn(): (readonly [TechniqueName, ReadonlySet<string>])[] {
    return [...this.byTechnique].filter(([name]) => Object.hasOwn(this.farol.techniques, name));
  }

  private programs(): { name: string; chunks: Set<string> }[] {
    const { gl } = this;
    const programs = (this.farol.webgl.info.programs ?? []) as unknown as Program[];
    return programs.map(({ name, vertexShader, fragmentShader }) => ({
      name,
      chunks: chunksOf(`${gl.getShaderSource(vertexShader)}\n${gl.getShaderSource(fragmentShader)}`),
    }));
  }

  private liveChunks(): Set<string> {
    return new Set(this.programs().flatMap(({ chunks }) => [...chunks]));
  }

  /**
   * @param names - a chunk whose text the registry has already, the scene not yet, and those that depend on it
   * @throws MicroShaderCompileError when it does not compile where it is used, or alone where it is not
   */
  private probe(names: readonly string[]): void {
    const { gl, farol } = this;
    const registry = farol.microshaders;
    const texts = new Map(this.getTexts());
    for (const name of names) {
      const chunk = registry.get(name);
      if (chunk) texts.set(name, formatMicroShader(chunk));
    }
    const user = names.flatMap((name) => this.techniquesOf(name)).at(0) ?? null;
    probeMicroShader(gl, registry, texts, names, user, farol.techniques);
  }

  private async findAll(): Promise<void> {
    for (const technique of this.techniques) {
      if (this.byTechnique.has(technique)) continue;
      await this.farol.techniques[technique].lazy?.load();
      await idle();
      this.byTechnique.set(technique, this.chunksWith({ technique }));
    }
    for (const view of VIEWS) {
      if (this.byView.has(view)) continue;
      await idle();
      this.byView.set(view, this.chunksWith({ technique: 'clustered-forward', view }));
    }
  }

  private chunksWith(options: Parameters<typeof dryRun>[1]): Set<string> {
    const all = new Set<string>();
    const sources = dryRun(this.gl, options, new Map(), this.farol.techniques);
    for (const { text } of sources) for (const name of chunksOf(text)) all.add(name);
    return all;
  }
}

/** Lets the page do what waits. */
export const idle = (): Promise<void> =>
  new Promise((resolve) => {
    if ('requestIdleCallback' in window) requestIdleCallback(() => resolve(), { timeout: 100 });
    else setTimeout(resolve);
  });
