import type { Frame } from '../../frame/Frame';
import type { RenderItem } from '../../frame/RenderItem';
import { GBuffer } from '../../gbuffer/GBuffer';
import { attachmentIndex } from '../../gbuffer/gbufferNames';
import { exceedsLite, shadingModelOf } from '../../gbuffer/shadingModel';

/**
 * True for an item that the G-buffer holds without visible loss; forward passes draw others.
 * @param isLite - whether it is the G-buffer of the quality 'lite' (`Frame.isLite`). Default false
 */
export function fitsGBuffer(item: RenderItem, isLite = false): boolean {
  const { route, layered, material } = item;
  return route === 'split' && !layered && shadingModelOf(material) !== null && !(isLite && exceedsLite(material));
}

/** G-buffer of a pass, replaced when a frame needs other attachments. */
export class GBufferTarget {
  private made: GBuffer | null = null;

  /** @param keepsDistance - whether distances are stored where depth is too coarse for positions */
  constructor(private readonly keepsDistance = true) {}

  get bytes(): number {
    return this.made?.bytes ?? 0;
  }

  /** Binds the G-buffer of a frame, sized and cleared. @throws Error when the device has too few draw buffers for it */
  begin(frame: Frame): GBuffer {
    // distances are kept once stored: cameras that need and do not need them may alternate
    const stores = this.keepsDistance && (frame.storesDistance || this.made?.storesDistance === true);
    if (this.made !== null && !this.fits(this.made, frame, stores)) this.dispose();
    const gbuffer = (this.made ??= new GBuffer(frame.webgl, frame.gbufferExtras, stores, frame.isLite));
    gbuffer.setSize(frame.width, frame.height);
    gbuffer.accumulation = gbuffer.emissive;
    frame.uniforms.farol_lite.value = gbuffer.isLite;
    frame.gbufferPixel = gbuffer.bytes / (frame.width * frame.height) - 4;
    frame.bind(gbuffer.target);
    // depth 1 marks empty pixels: other attachments need no clear, which costs as much as a draw
    frame.clear(0, true);
    // the flags, in the albedo's alpha, tell a surface at depth 1 from an empty pixel
    if (frame.queue.reachesFar) frame.clearOne(attachmentIndex.albedo);
    return gbuffer;
  }

  dispose(): void {
    this.made?.dispose();
    this.made = null;
  }

  private fits({ extras, storesDistance, isLite }: GBuffer, frame: Frame, stores: boolean): boolean {
    const { gbufferExtras } = frame;
    if (isLite !== frame.isLite || storesDistance !== stores || extras.length !== gbufferExtras.length) return false;
    for (let i = 0; i < extras.length; i++) if (extras[i] !== gbufferExtras[i]) return false;
    return true;
  }
}
