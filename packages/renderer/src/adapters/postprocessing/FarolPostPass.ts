import { RenderPass } from 'postprocessing';
import type { Camera, Material, Scene, WebGLRenderer, WebGLRenderTarget } from 'three';
import type { FarolRenderer } from '../../renderer/FarolRenderer';

/**
 * Draws a scene by Farol in the EffectComposer of pmndrs' postprocessing: put it where `RenderPass` stood. Everything of
 * that pass works as before: clear pass, selection, background and shadow switches, override material; and depth is left
 * for the passes that read it.
 *
 * @example
 * const composer = new EffectComposer(webgl, { frameBufferType: HalfFloatType });
 * composer.addPass(new FarolPostPass(farol, scene, camera));
 * composer.addPass(new EffectPass(camera, new BloomEffect()));
 *
 * @see https://pmndrs.github.io/postprocessing/public/docs/class/src/passes/RenderPass.js~RenderPass.html
 */
export class FarolPostPass extends RenderPass {
  /** The WebGLRenderer in all but `render`, for RenderPass to draw with. */
  private readonly standIn: WebGLRenderer;

  /**
   * @param farol - renderer that draws the scene; stays the host's to dispose
   * @param overrideMaterial - drawn with in place of all materials; default none
   */
  constructor(
    readonly farol: FarolRenderer,
    scene: Scene,
    camera: Camera,
    overrideMaterial?: Material,
  ) {
    super(scene, camera, overrideMaterial);
    this.name = 'FarolPostPass';
    const render: WebGLRenderer['render'] = (scene, camera) => farol.render(scene, camera);
    this.standIn = Object.create(farol.webgl, { render: { value: render } }) as WebGLRenderer;
  }

  /** @throws Error when the composer has another WebGLRenderer than `farol` */
  override render(
    webgl: WebGLRenderer,
    inputBuffer: WebGLRenderTarget,
    outputBuffer: WebGLRenderTarget,
    deltaTime?: number,
    stencilTest?: boolean,
  ): void {
    if (webgl !== this.farol.webgl) {
      throw new Error(
        'FarolPostPass: its FarolRenderer was made for another WebGLRenderer than the composer; give both the same.',
      );
    }
    super.render(this.standIn, inputBuffer, outputBuffer, deltaTime, stencilTest);
  }
}
