import { type MicroShaderRegistry, techniques, type TechniqueName, type View } from '@farol/renderer';
import { formatMicroShader } from '@farol/renderer/authoring';
import type { WebGLRenderer } from 'three';
import { Signal } from '../model/Signal';
import { chunksOf, dryRun } from './dryRun';
import { probeMicroShader } from './probeMicroShader';

/** Views that draw with chunks of their own. */
const VIEWS: readonly View[] = ['grid', 'lighting', 'light-count', 'overdraw'];

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

  /** @param getTexts - the microshaders of the scene */
  constructor(
    private readonly webgl: WebGLRenderer,
    private readonly registry: MicroShaderRegistry,
    private readonly getTexts: () => ReadonlyMap<string, string>,
  ) {
    // a chunk that is in no program would be seen broken only when somebody draws with it
    registry.addCheck((names) => {
      const live = this.liveChunks();
      if (!names.some((name) => live.has(name))) this.probe(names);
    });
  }

  private get gl(): WebGL2RenderingContext {
    return this.webgl.getContext() as WebGL2RenderingContext;
  }

  /** Finds what each technique and view draws with, one after the other, without holding up the page. */
  find(): Promise<void> {
    this.search ??= this.findAll();
    return this.search;
  }

  /** Whether everything is known. */
  get isKnown(): boolean {
    return this.byTechnique.size > 0 && this.byView.size === VIEWS.length;
  }

  /** Techniques that draw with a chunk, 'auto' left out. */
  techniquesOf(name: string): TechniqueName[] {
    return [...this.byTechnique].filter(([, chunks]) => chunks.has(name)).map(([technique]) => technique);
  }

  /** Views, besides the final picture, that draw with a chunk. */
  viewsOf(name: string): View[] {
    const common = this.techniquesOf(name).length === this.byTechnique.size;
    return common ? [] : [...this.byView].filter(([, chunks]) => chunks.has(name)).map(([view]) => view);
  }

  /** Names of the programs on the device that hold a chunk. */
  programsOf(name: string): string[] {
    return this.programs()
      .filter(({ chunks }) => chunks.has(name))
      .map((program) => program.name);
  }

  private programs(): { name: string; chunks: Set<string> }[] {
    const { gl } = this;
    const programs = (this.webgl.info.programs ?? []) as unknown as Program[];
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
    const { gl, registry } = this;
    const texts = new Map(this.getTexts());
    for (const name of names) {
      const chunk = registry.get(name);
      if (chunk) texts.set(name, formatMicroShader(chunk));
    }
    const user = names.flatMap((name) => this.techniquesOf(name)).at(0) ?? null;
    probeMicroShader(gl, registry, texts, names, user);
  }

  private async findAll(): Promise<void> {
    const names = (Object.keys(techniques) as TechniqueName[]).filter((name) => name !== 'auto');
    for (const technique of names) {
      await idle();
      this.byTechnique.set(technique, this.chunksWith({ technique }));
    }
    for (const view of VIEWS) {
      await idle();
      this.byView.set(view, this.chunksWith({ technique: 'clustered-forward', view }));
    }
    this.changed.emit();
  }

  private chunksWith(options: Parameters<typeof dryRun>[1]): Set<string> {
    const all = new Set<string>();
    for (const { text } of dryRun(this.gl, options, new Map())) for (const name of chunksOf(text)) all.add(name);
    return all;
  }
}

/** Lets the page do what waits. */
const idle = (): Promise<void> =>
  new Promise((resolve) => {
    if ('requestIdleCallback' in window) requestIdleCallback(() => resolve(), { timeout: 100 });
    else setTimeout(resolve);
  });
