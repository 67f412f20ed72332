import { FarolRenderer, type TechniqueName } from '@farol/renderer';
import * as THREE from 'three';

/** An image of linear floats, bottom row first, that crosses from the page to the test as plain JSON. */
export interface PageImage {
  width: number;
  height: number;
  data: Float32Array;
}

export interface BenchOptions {
  /** Samples of the target: above 0 it is multisampled, in half floats. */
  readonly samples?: number;
  readonly renderer?: THREE.WebGLRendererParameters;
  /** Whether the test loses this bench's context: the bench then gets a new one, and shared ones stay whole. */
  readonly losesContext?: boolean;
  readonly target?: THREE.RenderTargetOptions;
}

/** Canvases, oldest first, by the parameters (as text) that their WebGL contexts were made with. */
const canvases = new Map<string, HTMLCanvasElement[]>();
/** Canvases that a Bench uses, or whose context a test has lost. */
const taken = new Set<HTMLCanvasElement>();
/** Benches made since the last release. */
const made = new Set<Bench>();
const undone: (() => void)[] = [];

/** Undoes a test's change of the page's environment, such as methods of WebGL, when the test has ended. */
export const atRelease = (undo: () => void): void => void undone.push(undo);

/** Loses the context and has it restored. */
export async function loseContext(webgl: THREE.WebGLRenderer): Promise<void> {
  const canvas = webgl.domElement;
  const extension = webgl.getContext().getExtension('WEBGL_lose_context')!;
  const event = (name: string) => new Promise((resolve) => canvas.addEventListener(name, resolve, { once: true }));
  const lost = event('webglcontextlost');
  extension.loseContext();
  await lost;
  const restored = event('webglcontextrestored');
  // in a later task: the browser restores no context in the task that tells of its loss
  setTimeout(() => extension.restoreContext());
  await restored;
}

/** One WebGLRenderer, a float target, and Farol on it: draws a scene by stock three and by a technique. */
export class Bench {
  readonly webgl: THREE.WebGLRenderer;
  private wasLost = false;
  readonly farol: FarolRenderer;
  readonly target: THREE.WebGLRenderTarget;
  private madeEnvironment: THREE.Texture | null = null;

  constructor(
    public width: number,
    public height: number,
    { samples = 0, renderer = {}, losesContext = false, target = {} }: BenchOptions = {},
  ) {
    const parameters: THREE.WebGLRendererParameters = { antialias: false, ...renderer };
    const { antialias, depth, stencil, preserveDrawingBuffer, premultipliedAlpha, powerPreference } = parameters;
    const key = JSON.stringify([antialias, depth, stencil, preserveDrawingBuffer, premultipliedAlpha, powerPreference]);
    const known = canvases.get(key) ?? [];
    // the oldest context: most shaders are compiled in it already
    const canvas = losesContext ? undefined : known.find((each) => !taken.has(each));
    this.webgl = new THREE.WebGLRenderer({ ...parameters, ...(canvas && { canvas }) });
    if (!canvas) canvases.set(key, [...known, this.webgl.domElement]);
    taken.add(this.webgl.domElement);
    made.add(this);
    this.webgl.domElement.addEventListener('webglcontextlost', () => (this.wasLost = true));
    this.webgl.setSize(width, height, false);
    this.farol = new FarolRenderer(this.webgl);
    this.target = new THREE.WebGLRenderTarget(width, height, {
      type: samples > 0 ? THREE.HalfFloatType : THREE.FloatType,
      samples,
      ...target,
    });
  }

  /**
   * Disposes of all Benches, and keeps their contexts for others: to the rasteriser, a shader is another in each context. To be
   * called when a test has ended.
   *
   * @returns contexts that the page has
   */
  static release(): number {
    for (const undo of undone.splice(0).toReversed()) undo();
    // tables of stock three's area lights, which RectAreaLightUniformsLib adds
    for (const name of Object.keys(THREE.UniformsLib))
      if (name.startsWith('LTC_')) Reflect.deleteProperty(THREE.UniformsLib, name);
    for (const bench of made) bench.free();
    return [...canvases.values()].flat().length;
  }

  /** Disposes of this bench, and keeps its context for other benches. */
  free(): void {
    made.delete(this);
    const { webgl, farol, target } = this;
    // three would delete objects that the restored context does not have
    if (this.wasLost) return;
    const context = webgl.getContext() as WebGL2RenderingContext;
    farol.dispose();
    target.dispose();
    webgl.dispose();
    // removes methods that a test has put on the context
    for (const name of Object.keys(context)) Reflect.deleteProperty(context, name);
    webgl.resetState();
    while (context.getError() !== 0);
    taken.delete(webgl.domElement);
  }

  /** Draws pictures of another size from now on. */
  setSize(width: number, height: number): void {
    this.width = width;
    this.height = height;
    this.webgl.setSize(width, height, false);
    this.target.setSize(width, height);
  }

  /** An environment map made of a blue room with orange walls; made when first asked for, since filtering it takes seconds. */
  environment(): THREE.Texture {
    return (this.madeEnvironment ??= this.makeEnvironment());
  }

  stock(scene: THREE.Scene, camera: THREE.Camera): PageImage {
    return this.draw(() => this.webgl.render(scene, camera));
  }

  byTechnique(technique: TechniqueName, scene: THREE.Scene, camera: THREE.Camera): PageImage {
    this.farol.technique = technique;
    return this.draw(() => this.farol.render(scene, camera));
  }

  /** Loses the context, as said by `losesContext`, and has it restored; a test has to forgive the messages of that. */
  loseContext(): Promise<void> {
    return loseContext(this.webgl);
  }

  /** Linked programs of the renderer. */
  get programs(): number {
    return this.webgl.info.programs?.length ?? 0;
  }

  private makeEnvironment(): THREE.Texture {
    const room = new THREE.Scene();
    room.background = new THREE.Color(0.5, 0.6, 0.8);
    const walls = new THREE.MeshBasicMaterial({ color: 0xffcc88, side: THREE.BackSide });
    room.add(new THREE.Mesh(new THREE.BoxGeometry(4, 4, 4), walls));
    return new THREE.PMREMGenerator(this.webgl).fromScene(room, 0, 0.1, 100, { size: 64 }).texture;
  }

  /** The picture that `render` draws to the target. */
  draw(render: () => void): PageImage {
    const { webgl, target, width, height } = this;
    webgl.setRenderTarget(target);
    render();
    const data = this.read();
    webgl.setRenderTarget(null);
    const error = webgl.getContext().getError();
    if (error !== 0) throw new Error(`WebGL error ${error}`);
    return { width, height, data };
  }

  private read(): Float32Array {
    const { webgl, target, width, height } = this;
    const data = new Float32Array(width * height * 4);
    if (target.texture.type === THREE.FloatType) {
      webgl.readRenderTargetPixels(target, 0, 0, width, height, data);
    } else {
      const halves = new Uint16Array(data.length);
      webgl.readRenderTargetPixels(target, 0, 0, width, height, halves);
      halves.forEach((half, i) => (data[i] = THREE.DataUtils.fromHalfFloat(half)));
    }
    return data;
  }
}
