import type { Frame } from '../../frame/Frame';
import type { RenderItem } from '../../frame/RenderItem';
import { GBuffer } from '../../gbuffer/GBuffer';
import { attachmentIndex } from '../../gbuffer/gbufferNames';
import { shadingModelOf } from '../../gbuffer/shadingModel';

/** True for an item that the G-buffer holds without loss that shows; others are left to forward passes. */
export function fitsGBuffer(item: RenderItem): boolean {
  return item.route === 'split' && !item.layered && shadingModelOf(item.material) !== null;
}

/** The G-buffer of a pass: made for what a frame asks of it, and made anew when that changes. */
export class GBufferTarget {
  private made: GBuffer | null = null;

  /** @param keepsDistance - whether distances are stored where depth is too coarse for positions */
  constructor(private readonly keepsDistance = true) {}

  get bytes(): number {
    return this.made?.bytes ?? 0;
  }

  /** Binds the G-buffer of a frame, sized and cleared. @throws Error when the device has too few draw buffers for it */
  begin(frame: Frame): GBuffer {
    // a G-buffer that stores distances keeps them: cameras may take turns
    const stores = this.keepsDistance && (frame.storesDistance || this.made?.storesDistance === true);
    if (this.made !== null && !this.fits(this.made, frame, stores)) this.dispose();
    const gbuffer = (this.made ??= new GBuffer(frame.webgl, frame.gbufferExtras, stores));
    gbuffer.setSize(frame.width, frame.height);
    gbuffer.accumulation = gbuffer.emissive;
    frame.bind(gbuffer.target);
    // depth 1 says that nothing is drawn there: other attachments need no clear, which costs as much as a draw
    frame.clear(0, true);
    // a surface at depth 1 is told from nothing by its flags, beside the albedo
    if (frame.queue.reachesFar) frame.clearOne(attachmentIndex.albedo);
    return gbuffer;
  }

  dispose(): void {
    this.made?.dispose();
    this.made = null;
  }

  private fits({ extras, storesDistance }: GBuffer, { gbufferExtras }: Frame, stores: boolean): boolean {
    if (storesDistance !== stores || extras.length !== gbufferExtras.length) return false;
    for (let i = 0; i < extras.length; i++) if (extras[i] !== gbufferExtras[i]) return false;
    return true;
  }
}
