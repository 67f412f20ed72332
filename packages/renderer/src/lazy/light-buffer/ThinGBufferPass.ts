import { DepthTexture, FloatType, LessEqualDepth, NearestFilter, RGFormat, Vector4, WebGLRenderTarget } from 'three';
import type { Frame } from '../../frame/Frame';
import { thinGBufferLayout } from './thinGBufferLayout';
import { isLightBufferMaterial } from './isLightBufferMaterial';
import { resetObject, setObject } from './objectAttribute';
import { thinGBufferTwins, type ThinGBufferTwins } from './thinGBufferTwins';
import type { RenderItem } from '../../frame/RenderItem';
import { drawLayers } from './drawLayers';
import { gridFit, gridTexels } from './gridFit';
import { objectNumber } from './objectNumbers';
import type { Pass } from '../../frame/Pass';

/** How large the buffers of lighting are, and what is in them. */
export interface ThinGBufferOptions {
  /** Texels a pixel of the picture, along a side: above 0, at most 1. Read each frame. */
  readonly scale: { readonly value: number };
  /** Transparent things are in it too, each layer in one texel of each two by two. */
  readonly stipple: boolean;
}

/**
 * Draws what the light buffer can light, with no more than lights need to know of it: normal, specular lobe, depth, and
 * which object it is.
 * @see Engel 2009, The Light Pre-Pass Renderer; Kircher and Lawrance 2009, Inferred Lighting; thesis 2.2.3.3.2
 */
export class ThinGBufferPass implements Pass {
  readonly name = 'thin g-buffer';
  readonly reads = [] as const;
  readonly writes = ['thin-gbuffer', 'scene-depth'] as const;
  target: WebGLRenderTarget | null = null;
  /** Texels a pixel, along a side. */
  readonly scale = { value: 1 };
  /** From the picture's normalised device coordinates to the buffer's, by `gridFit`. */
  readonly fit = { value: new Vector4(1, 1, 0, 0) };
  /** The opaque items drawn; the n-th has `objectNumber(n)`. */
  readonly items: RenderItem[] = [];
  private readonly twins: ThinGBufferTwins;

  constructor(private readonly options: ThinGBufferOptions) {
    this.twins = thinGBufferTwins(this.scale, this.fit);
  }

  get bytes(): number {
    return this.target
      ? this.target.width * this.target.height * (thinGBufferLayout.bytes + 4 * this.target.textures.length)
      : 0;
  }

  render(frame: Frame): void {
    this.prepareTarget(frame);
    const { items } = this;
    items.length = 0;
    try {
      for (const item of frame.queue.opaque) {
        if (!item.splits || item.layered || !isLightBufferMaterial(item.material)) continue;
        setObject(frame.gl, objectNumber(items.length), 0);
        frame.drawTwin(item, this.twins.opaque);
        items.push(item);
      }
      if (this.options.stipple) this.drawTransparent(frame);
    } finally {
      resetObject(frame.gl);
    }
  }

  /** True for a transparent item whose layers are in the buffer. */
  isStippled(item: RenderItem): boolean {
    const { material, lit } = item;
    return (
      this.options.stipple &&
      lit &&
      !item.ownShader &&
      !item.layered &&
      material.depthTest &&
      material.depthFunc === LessEqualDepth &&
      isLightBufferMaterial(material)
    );
  }

  dispose(): void {
    this.target?.depthTexture?.dispose();
    this.target?.dispose();
    this.target = null;
    this.items.length = 0;
  }

  private prepareTarget(frame: Frame): void {
    const scale = this.options.scale.value;
    const width = gridTexels(frame.width, scale);
    const height = gridTexels(frame.height, scale);
    this.scale.value = scale;
    gridFit(frame.width, frame.height, scale, this.fit.value);
    // what stores distances goes on to: cameras may take turns
    if (frame.storesDistance && this.target?.textures.length === 1) this.dispose();
    this.target ??= makeTarget(frame.storesDistance);
    if (this.target.width !== width || this.target.height !== height) this.target.setSize(width, height);
    frame.bind(this.target);
    frame.clear(1, true);
  }

  private drawTransparent(frame: Frame): void {
    let layer = 0;
    for (const item of frame.queue.transparent) {
      if (this.isStippled(item)) layer = drawLayers(frame, item, this.twins.stippled, this.items.length, layer);
    }
  }
}

/** @param storesDistance with an attachment more, of how far each texel is, see storedDistance.glsl */
function makeTarget(storesDistance: boolean): WebGLRenderTarget {
  const target = new WebGLRenderTarget(1, 1, {
    count: storesDistance ? 2 : 1,
    format: thinGBufferLayout.format,
    type: thinGBufferLayout.type,
    minFilter: NearestFilter,
    magFilter: NearestFilter,
    depthTexture: new DepthTexture(1, 1, FloatType),
  });
  if (storesDistance) target.textures[1].format = RGFormat;
  return target;
}
