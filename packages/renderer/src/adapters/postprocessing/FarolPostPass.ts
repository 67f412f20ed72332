import { RenderPass } from 'postprocessing';
import type { Camera, Material, Scene, WebGLRenderer, WebGLRenderTarget } from 'three';
import type { FarolRenderer } from '../../renderer/FarolRenderer';

/**
 * Draws a scene by Farol in the EffectComposer of pmndrs' postprocessing, in place of `RenderPass`. All features of that
 * pass still work: clear pass, selection, background and shadow switches, override material, and depth for later passes.
 *
 * @example
 * const composer = new EffectComposer(webgl, { frameBufferType: HalfFloatType });
 * composer.addPass(new FarolPostPass(farol, scene, camera));
 * composer.addPass(new EffectPass(camera, new BloomEffect()));
 *
 * @see https://pmndrs.github.io/postprocessing/public/docs/class/src/passes/RenderPass.js~RenderPass.html
 */
export class FarolPostPass extends RenderPass {
  /** Stand-in for the WebGLRenderer with Farol's `render`, which RenderPass draws with. */
  private readonly standIn: WebGLRenderer;

  /**
   * @param farol - renderer that draws the scene; the host disposes it
   * @param overrideMaterial - material in place of all materials; default none
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
