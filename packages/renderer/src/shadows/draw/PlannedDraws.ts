import { type LightShadow, VSMShadowMap, type WebGLRenderer, type WebGLRenderTarget } from 'three';
import type { MicroShaderRegistry } from '../../microshaders';
import type { ShadowAtlases } from '../atlas/ShadowAtlases';
import { ShadowBounds } from '../screen-tiles';
import { softSizeOf } from '../slots/AreaShadowLight';
import type { CookieSlot } from '../slots/CookieSlot';
import type { LightSlots } from '../slots/LightSlots';
import type { ShadowSlot } from '../slots/ShadowSlot';
import { CookieDraws } from './CookieDraws';
import { HostShadowMaps } from './HostShadowMaps';
import { MomentDraws } from './MomentDraws';
import { RegionDrawer } from './RegionDrawer';
import { ShadowMapDraws } from './ShadowMapDraws';

/** Shadows whose map a renderer of the page has drawn. */
const drawnShadows = new WeakSet<LightShadow>();

/** The draws of a frame, as `ShadowMaps` has planned them: maps, images, copies of maps for three's addons, bounds. */
export class PlannedDraws {
  readonly maps: ShadowSlot[] = [];
  readonly images: CookieSlot[] = [];
  readonly copies: ShadowSlot[] = [];
  readonly bounds: ShadowBounds;
  readonly casters: ShadowMapDraws;
  readonly hostMaps: HostShadowMaps;
  private readonly moments: MomentDraws;
  private readonly cookies: CookieDraws;

  constructor(
    private readonly webgl: WebGLRenderer,
    microshaders: MicroShaderRegistry,
    private readonly atlases: ShadowAtlases,
  ) {
    this.casters = new ShadowMapDraws(webgl, microshaders);
    const drawer = new RegionDrawer(webgl, microshaders);
    this.moments = new MomentDraws(webgl, drawer, this.casters);
    this.cookies = new CookieDraws(drawer);
    this.hostMaps = new HostShadowMaps(webgl, drawer);
    this.bounds = new ShadowBounds(webgl, drawer);
  }

  /** Bytes of the targets in which maps are blurred. */
  get bytes(): number {
    return this.moments.bytes;
  }

  get hasWork(): boolean {
    return this.maps.length + this.images.length + this.copies.length > 0 || this.bounds.hasWork;
  }

  /** Begins a frame: clears the lists of planned draws. */
  begin(): void {
    this.maps.length = this.images.length = this.copies.length = this.casters.proxies.length = 0;
    this.bounds.begin();
  }

  /** Plans the copies of cookies and profiles that are used in the frame and out of date. */
  planImages(slots: LightSlots): void {
    for (const copies of slots.copies) {
      for (const cookie of copies.values()) {
        if (!slots.isLit(cookie) || cookie.sampler >= 0) continue;
        if (cookie.placement.region === null || cookie.map.isCurrent) continue;
        cookie.map.plan(false);
        this.images.push(cookie);
      }
    }
  }

  /** @param type - `shadowMap.type` of the frame */
  render(type: number): void {
    const { webgl, maps } = this;
    const { depths, colours } = this.atlases;
    const target = webgl.getRenderTarget() as WebGLRenderTarget | null;
    const face = webgl.getActiveCubeFace();
    const level = webgl.getActiveMipmapLevel();
    const isVariance = type === VSMShadowMap;
    this.casters.setComparison(depths);
    this.casters.send();
    if (isVariance) for (const slot of maps) this.moments.render(slot, colours);
    else if (maps.length > 0) {
      webgl.setRenderTarget(depths.target);
      this.casters.drawMaps(maps);
    }
    for (const { map, shadow } of maps) {
      map.draw();
      drawnShadows.add(shadow);
      if (shadow.needsUpdate) shadow.needsUpdate = false;
    }
    for (const cookie of this.images) this.cookies.render(cookie, colours);
    for (const slot of this.copies) this.hostMaps.render(slot, isVariance ? colours : depths, type);
    this.bounds.render(depths);
    webgl.setRenderTarget(target, face, level);
  }

  dispose(): void {
    for (const held of [this.casters, this.moments, this.cookies, this.bounds, this.hostMaps]) held.dispose();
  }
}

/**
 * Whether the host has requested a map before (`needsUpdate`), so that a missing map is drawn even with updates off. If this
 * code was not loaded then, three reset the request and drew its own map. Area lights have no requests, and always count.
 */
export const wasAskedFor = ({ shadow, light }: ShadowSlot) =>
  drawnShadows.has(shadow) || shadow.map !== null || softSizeOf(light) > 0;
