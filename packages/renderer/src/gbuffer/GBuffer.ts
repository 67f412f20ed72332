import { DepthTexture, FloatType, NearestFilter, RGBAFormat, type Texture, type WebGLRenderer } from 'three';
import { fitTarget } from '../gpu/fitTarget';
import { drawBuffersOf } from '../gpu/checkDevice';
import { attachmentIndex } from './gbufferNames';
import { targetBytes } from '../gpu/targetBytes';
import { formatOf, gbufferLayout, type GBufferAttachment } from './gbufferLayout';
import { WebGLMultipleRenderTargets } from '../three/WebGLMultipleRenderTargets';

/** Geometry buffer: the attachments of `gbufferLayout`, those that effects add, and a depth texture. */
export class GBuffer {
  readonly target: WebGLMultipleRenderTargets;
  readonly layout: readonly GBufferAttachment[];
  /** Emissive and indirect light: the first attachment, or an effect's replacement of it for the rest of a frame. */
  accumulation: Texture;

  /**
   * @param extras - attachments after those of `gbufferLayout`
   * @param storesDistance - whether distances are stored beside normals, to compute positions from in place of depth
   * @param isLite - whether to use the smaller formats of the quality 'lite'
   * @throws Error when the device has fewer draw buffers than the layout has attachments
   */
  constructor(
    webgl: WebGLRenderer,
    readonly extras: readonly GBufferAttachment[] = [],
    readonly storesDistance = false,
    readonly isLite = false,
  ) {
    const layout = (this.layout = [...gbufferLayout, ...extras]);
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
    layout.forEach((row, i) => {
      const { name } = row;
      // R11F_G11F_B10F targets need EXT_color_buffer_float
      const isSmall = isLite && (name !== 'accumulation' || webgl.extensions.has('EXT_color_buffer_float'));
      const { format, type } = formatOf(row, isSmall);
      const texture = this.target.textures[i];
      texture.name = `G-buffer ${name}`;
      texture.format = name === 'normal' && storesDistance ? RGBAFormat : format;
      texture.type = type;
    });
    this.accumulation = this.emissive;
  }

  /** First attachment, with emissive and indirect light. */
  get emissive(): Texture {
    return this.target.textures[attachmentIndex.accumulation];
  }
  get normal(): Texture {
    return this.target.textures[attachmentIndex.normal];
  }
  get albedo(): Texture {
    return this.target.textures[attachmentIndex.albedo];
  }
  get material(): Texture {
    return this.target.textures[attachmentIndex.material];
  }
  get depth(): DepthTexture {
    return this.target.depthTexture!;
  }

  /** Bytes of all attachments and depth. */
  get bytes(): number {
    return targetBytes(this.target);
  }

  /** Resizes the G-buffer (pixels). */
  setSize(width: number, height: number): void {
    fitTarget(this.target, width, height);
  }

  dispose(): void {
    this.target.depthTexture?.dispose();
    this.target.dispose();
  }
}
