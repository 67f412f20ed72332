import { DepthTexture, FloatType, NearestFilter, RGBAFormat, type WebGLRenderer } from 'three';
import { drawBuffersOf } from '../gpu/checkDevice';
import { attachmentIndex } from './gbufferNames';
import { gbufferLayout, type GBufferAttachment } from './gbufferLayout';
import { WebGLMultipleRenderTargets } from '../three/WebGLMultipleRenderTargets';

/** Geometry buffer: the attachments of `gbufferLayout` and a depth texture. */
export class GBuffer {
  readonly target: WebGLMultipleRenderTargets;

  /**
   * @param layout begins as `gbufferLayout`; an effect may want more
   * @param storesDistance how far surfaces are is stored beside their normals: positions come from there, not from depth
   * @throws Error when the device has fewer draw buffers than the layout has attachments
   */
  constructor(
    webgl: WebGLRenderer,
    readonly layout: readonly GBufferAttachment[] = gbufferLayout,
    readonly storesDistance = false,
  ) {
    const gl = webgl.getContext() as WebGL2RenderingContext;
    const most = drawBuffersOf(gl);
    if (most < layout.length) {
      throw new Error(
        `Farol: the G-buffer has ${layout.length} attachments and this device draws to ${most} at once; use a technique without a G-buffer, such as 'forward'.`,
      );
    }
    this.target = new WebGLMultipleRenderTargets(1, 1, layout.length, {
      minFilter: NearestFilter,
      magFilter: NearestFilter,
      depthTexture: new DepthTexture(1, 1, FloatType),
    });
    layout.forEach(({ name, format, type }, i) => {
      const texture = this.target.textures[i];
      texture.name = `G-buffer ${name}`;
      texture.format = name === 'normal' && storesDistance ? RGBAFormat : format;
      texture.type = type;
    });
  }

  get accumulation() {
    return this.target.textures[attachmentIndex.accumulation];
  }
  get normal() {
    return this.target.textures[attachmentIndex.normal];
  }
  get albedo() {
    return this.target.textures[attachmentIndex.albedo];
  }
  get material() {
    return this.target.textures[attachmentIndex.material];
  }
  get depth(): DepthTexture {
    return this.target.depthTexture!;
  }

  /** Bytes of all attachments and depth. */
  get bytes(): number {
    const perPixel = this.layout.reduce((sum, a) => sum + a.bytes, this.storesDistance ? 8 : 4);
    return this.target.width * this.target.height * perPixel;
  }

  /** @param width pixels @param height pixels */
  setSize(width: number, height: number): void {
    if (this.target.width !== width || this.target.height !== height) this.target.setSize(width, height);
  }

  dispose(): void {
    this.target.depthTexture?.dispose();
    this.target.dispose();
  }
}
