import { Signal } from '@farol/editing';
import type { FarolRenderer, TechniqueName, View } from '@farol/renderer';
import { formatMicroShader } from '@farol/renderer/microshaders';
import { chunksOf, dryRun } from './dryRun';
import { isOfSurface } from './MicroShaderEditing';
import { probeMicroShader } from './probeMicroShader';

/** Debug views with microshaders of their own. */
export const VIEWS: readonly View[] = ['grid', 'lighting', 'light-count', 'overdraw'];

interface Program {
  readonly name: string;
  readonly vertexShader: WebGLShader;
  readonly fragmentShader: WebGLShader;
}

/** Finds where each microshader is used: techniques, debug views, and compiled programs. */
export class MicroShaderUses {
  /** Emits when more uses of microshaders are known. */
  readonly changed = new Signal();

  private readonly byTechnique = new Map<TechniqueName, ReadonlySet<string>>();
  private readonly byView = new Map<View, ReadonlySet<string>>();
  private search: Promise<void> | null = null;

  /**
   * @param farol - renderer of the viewport
   * @param getTexts - gives the scene's microshaders
   */
  constructor(
    private readonly farol: FarolRenderer,
    private readonly getTexts: () => ReadonlyMap<string, string>,
  ) {
    // microshaders outside all programs are compiled too, or errors would only appear once they are used
    farol.microshaders.addCheck((all) => {
      // microshaders of surfaces are compiled by SurfaceEditing
      const names = all.filter((name) => !isOfSurface(name));
      if (names.length === 0) return;
      const live = this.liveChunks();
      if (!names.some((name) => live.has(name))) this.probe(names);
    });
  }

  private get gl(): WebGL2RenderingContext {
    return this.farol.webgl.getContext() as WebGL2RenderingContext;
  }

  /** Techniques that draw themselves: all except 'auto', which selects one of them. */
  private get techniques(): TechniqueName[] {
    return (Object.keys(this.farol.techniques) as TechniqueName[]).filter((name) => name !== 'auto');
  }

  /**
   * Finds the microshaders of each technique and debug view, one after the other, without blocking the page. Results
   * are cached; a later call searches only techniques added since.
   */
  find(): Promise<void> {
    if (this.isKnown) return Promise.resolve();
    // continues if a plugin has added a technique meanwhile
    this.search ??= this.findAll()
      .finally(() => (this.search = null))
      .then(() => this.changed.emit());
    return this.search;
  }

  /** Whether all techniques and views have been searched. */
  get isKnown(): boolean {
    return this.byView.size === VIEWS.length && this.techniques.every((name) => this.byTechnique.has(name));
  }

  /** Techniques that use a microshader, except 'auto'. */
  techniquesOf(name: string): TechniqueName[] {
    return this.drawn.filter(([, chunks]) => chunks.has(name)).map(([technique]) => technique);
  }

  /** Debug views that use a microshader, except the final image. */
  viewsOf(name: string): View[] {
    const common = this.techniquesOf(name).length === this.drawn.length;
    return common ? [] : [...this.byView].filter(([, chunks]) => chunks.has(name)).map(([view]) => view);
  }

  /** Names of compiled programs that contain a microshader. */
  programsOf(name: string): string[] {
    return this.programs()
      .filter(({ chunks }) => chunks.has(name))
      .map((program) => program.name);
  }

  /** Microshaders of each technique searched so far, without removed techniques. */
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
   * Compiles microshaders that may be in no program.
   * @param names - a microshader with a new text in the registry but maybe not in the scene, then its dependents
   * @throws MicroShaderCompileError when one does not compile where it is used, or alone when it is unused
   */
  private probe(names: readonly string[]): void {
    const { gl, farol } = this;
    const registry = farol.microshaders;
    const texts = new Map(this.getTexts());
    const chunk = registry.get(names[0]);
    if (chunk) texts.set(names[0], formatMicroShader(chunk));
    else texts.delete(names[0]);
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

/** Yields to other tasks of the page. */
export const idle = (): Promise<void> =>
  new Promise((resolve) => {
    if ('requestIdleCallback' in window) requestIdleCallback(() => resolve(), { timeout: 100 });
    else setTimeout(resolve);
  });
