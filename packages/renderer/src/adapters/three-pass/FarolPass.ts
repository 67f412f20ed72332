import { type Camera, Color, type Material, type Scene, type WebGLRenderer, type WebGLRenderTarget } from 'three';
import { RenderPass } from 'three/addons/postprocessing/RenderPass.js';
import type { FarolRenderer } from '../../renderer/FarolRenderer';

/**
 * Draws a scene by Farol in three's EffectComposer, or in `WebGLRenderer.setEffects`, in place of `RenderPass`. The
 * picture is drawn to the composer's read buffer, or to the canvas if no pass follows; depth is in the buffer and its
 * depth texture, and the buffers are not swapped. `clear`, `clearDepth`, `clearColor`, `clearAlpha` and
 * `overrideMaterial` are those of `RenderPass`. (For pmndrs' postprocessing: `FarolPostPass`.)
 *
 * @example
 * const composer = new EffectComposer(webgl);
 * composer.addPass(new FarolPass(farol, scene, camera));
 * composer.addPass(new OutputPass());
 *
 * @see https://threejs.org/docs/#RenderPass
 */
export class FarolPass extends RenderPass {
  private readonly hostColor = new Color();

  /**
   * @param farol - renderer that draws the scene; the host disposes it
   * @param overrideMaterial - material that replaces all materials; null for none
   * @param clearColor - clear colour; null for the renderer's own
   * @param clearAlpha - clear alpha, 0 to 1; null for the renderer's own
   */
  constructor(
    readonly farol: FarolRenderer,
    scene: Scene,
    camera: Camera,
    overrideMaterial: Material | null = null,
    clearColor: Color | null = null,
    clearAlpha: number | null = null,
  ) {
    super(scene, camera, overrideMaterial, clearColor, clearAlpha);
  }

  /** @throws Error when the composer has another WebGLRenderer than `farol` */
  override render(webgl: WebGLRenderer, _writeBuffer: WebGLRenderTarget, readBuffer: WebGLRenderTarget): void {
    if (webgl !== this.farol.webgl) {
      throw new Error(
        'FarolPass: its FarolRenderer was made for another WebGLRenderer than the composer; give both the same.',
      );
    }
    const { scene, hostColor } = this;
    const { autoClear } = webgl;
    const alpha = webgl.getClearAlpha();
    const override = scene.overrideMaterial;
    webgl.getClearColor(hostColor);
    try {
      webgl.autoClear = false;
      if (this.overrideMaterial !== null) scene.overrideMaterial = this.overrideMaterial;
      if (this.clearColor !== null) webgl.setClearColor(this.clearColor, alpha);
      if (this.clearAlpha !== null) webgl.setClearAlpha(this.clearAlpha);
      if (this.clearDepth) webgl.clearDepth();
      webgl.setRenderTarget(this.renderToScreen ? null : readBuffer);
      if (this.clear) webgl.clear(webgl.autoClearColor, webgl.autoClearDepth, webgl.autoClearStencil);
      this.farol.render(scene, this.camera);
    } finally {
      webgl.setClearColor(hostColor, alpha);
      scene.overrideMaterial = override;
      webgl.autoClear = autoClear;
    }
  }
}
