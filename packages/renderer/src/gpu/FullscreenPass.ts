import type { IUniform, Mesh, RawShaderMaterial, ShaderMaterial, Texture, WebGLRenderTarget } from 'three';
import type { MicroShaderRegistry } from '../microshaders';
import { addMicroShaders } from '../microshaders/addMicroShaders';
import { FullscreenMesh } from './FullscreenMesh';
import { OutputMaterial, PassMaterial, type PassMaterialOptions } from './PassMaterial';
import { PassTarget, type PassTargetOptions } from './PassTarget';

/** Object by which full-screen passes are drawn: a `Frame`, or a drawer outside of frames. */
export interface MeshDrawer {
  readonly microshaders: MicroShaderRegistry;
  /** Uniforms that all passes of a renderer share. */
  readonly uniforms: Readonly<Record<string, IUniform>>;
  /** Binds a target for the draws that follow. */
  bind(target: WebGLRenderTarget): void;
  drawMesh(mesh: Mesh, material: RawShaderMaterial | ShaderMaterial): void;
  /** Compiles a material for the bound target, drawing nothing. */
  compileMesh(mesh: Mesh, material: RawShaderMaterial | ShaderMaterial): void;
}

/** Uniforms by name, as the pass's microshaders declare them. */
export type Uniforms = Record<string, IUniform>;

/** Options of the constructor of FullscreenPass. */
export interface FullscreenPassOptions<U extends Uniforms> extends Omit<
  PassMaterialOptions,
  'name' | 'vertex' | 'fragment' | 'uniforms'
> {
  /** Name of the program, for messages of the device and of tools. */
  readonly program: string;
  /** Microshaders whose mains form the fragment shader, in this order. */
  readonly fragment: string | readonly string[];
  /** Microshader whose main places the triangle. Default 'fullscreen': over the whole viewport. */
  readonly vertex?: string;
  /** Sources of the pass's own microshaders, by name, besides those of the renderer. Default none. */
  readonly microShaders?: Readonly<Record<string, string>>;
  /** The pass's own uniforms; set their values before a draw. Default none. */
  readonly uniforms?: U;
  /** Names of the shared uniforms that the shader reads as well, or 'all'. Default none. */
  readonly shared?: 'all' | readonly string[];
  /**
   * Whether output is tone mapped, fogged and encoded for the target, as three's materials are. Default false: values
   * are written unchanged.
   */
  readonly asThree?: boolean;
  /**
   * Whether the pass is drawn several times in a frame with different uniforms, which three would otherwise upload only once.
   * Default false.
   */
  readonly repeats?: boolean;
  /** Options of the pass's own target, for `drawToOwn`. Default none. */
  readonly target?: PassTargetOptions;
}

/**
 * A triangle over the whole viewport with a fragment shader composed of microshaders. Owns a program and, with the option
 * `target`, a target; both are created by the first draw, and again after `dispose`.
 *
 * @example
 * const brightness = new FullscreenPass({
 *   program: 'brightness',
 *   fragment: 'brightness',
 *   microShaders: { brightness },
 *   uniforms: { picture: { value: null as Texture | null } },
 *   target: { format: RedFormat },
 * });
 * brightness.uniforms.picture.value = texture;
 * const { texture } = brightness.drawToOwn(frame, frame.width, frame.height);
 */
export class FullscreenPass<U extends Uniforms = Uniforms> {
  /** The pass's own uniforms. */
  readonly uniforms: U;
  private readonly triangle = new FullscreenMesh();
  private readonly passTarget: PassTarget | null;
  private made: PassMaterial | OutputMaterial | null = null;

  constructor(private options: FullscreenPassOptions<U>) {
    this.uniforms = options.uniforms ?? ({} as U);
    this.passTarget = options.target === undefined ? null : new PassTarget(options.target);
  }

  /** Bytes of the pass's own target. */
  get bytes(): number {
    return this.passTarget?.bytes ?? 0;
  }

  /** The material, to set blending or depth state of a draw. */
  material(drawer: MeshDrawer): PassMaterial | OutputMaterial {
    return (this.made ??= this.make(drawer));
  }

  /** Draws over the viewport of the bound target. */
  draw(drawer: MeshDrawer): void {
    const material = this.material(drawer);
    if (this.options.repeats === true) material.uniformsNeedUpdate = true;
    drawer.drawMesh(this.triangle, material);
  }

  drawTo(drawer: MeshDrawer, target: WebGLRenderTarget): void {
    drawer.bind(target);
    this.draw(drawer);
  }

  /**
   * Binds the pass's own target, sized in texels, and draws to it.
   * @returns the target
   * @throws Error when the options name no target
   */
  drawToOwn(drawer: MeshDrawer, width: number, height: number): WebGLRenderTarget {
    const target = this.bindOwn(drawer, width, height);
    this.draw(drawer);
    return target;
  }

  /**
   * Binds the pass's own target, sized in texels.
   * @returns the target
   * @throws Error when the options name no target
   */
  bindOwn(drawer: MeshDrawer, width: number, height: number): WebGLRenderTarget {
    if (this.passTarget === null) throw new Error(`Farol: the pass "${this.options.program}" has no target; give one.`);
    const target = this.passTarget.of(width, height);
    drawer.bind(target);
    return target;
  }

  /** Texture of the pass's own target; null before the first draw to it. */
  get texture(): Texture | null {
    return this.passTarget?.current?.texture ?? null;
  }

  /** Compiles the program for the bound target, drawing nothing, so that no later frame waits for it. */
  compile(drawer: MeshDrawer): void {
    drawer.compileMesh(this.triangle, this.material(drawer));
  }

  /** Replaces microshaders or defines, from the next draw on. */
  protected recompose(parts: Pick<FullscreenPassOptions<U>, 'fragment' | 'defines'>): void {
    this.options = { ...this.options, ...parts };
    this.made?.dispose();
    this.made = null;
  }

  /** Frees target and program. */
  dispose(): void {
    this.passTarget?.dispose();
    this.made?.dispose();
    this.made = null;
  }

  private make(drawer: MeshDrawer): PassMaterial | OutputMaterial {
    const {
      program,
      fragment,
      vertex,
      microShaders,
      shared,
      asThree,
      repeats: _r,
      target: _t,
      ...state
    } = this.options;
    if (microShaders !== undefined) addMicroShaders(drawer.microshaders, program, microShaders);
    const options: PassMaterialOptions = {
      ...state,
      name: `Farol ${program}`,
      vertex: [vertex ?? 'fullscreen'],
      fragment: typeof fragment === 'string' ? [fragment] : fragment,
      uniforms: { ...sharedOf(drawer, shared), ...this.uniforms },
    };
    return asThree === true
      ? new OutputMaterial(drawer.microshaders, options)
      : new PassMaterial(drawer.microshaders, options);
  }
}

/** Shared uniforms of a pass. Other uniforms are left out, so that their textures are not bound while the pass may write them. */
function sharedOf({ uniforms }: MeshDrawer, shared: 'all' | readonly string[] = []): Uniforms {
  if (shared === 'all') return { ...uniforms };
  return Object.fromEntries(shared.map((name) => [name, uniforms[name]]));
}
