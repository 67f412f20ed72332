import { FloatType, NearestFilter, NoBlending, RGFormat, type Texture, Vector4, WebGLRenderTarget } from 'three';
import type { Frame } from '../../frame/Frame';
import { FullscreenPass } from '../../gpu/FullscreenPass';
import { targetBytes } from '../../gpu/targetBytes';
import particleKeys from './particleKeys.glsl?raw';
import particleSort from './particleSort.glsl?raw';
import { sortingNetwork } from './sortingNetwork';

/** Number of sorting passes in a frame for up to 1024 particles, which are then fully sorted. */
const PASSES = 23;
const FEW_PASSES = 4;
const MANY = 131_072;

const noTexture = () => ({ value: null as Texture | null });

/** Passes that sort particles, shared by all emitters. */
export function particleSortPasses() {
  const options = { blending: NoBlending, repeats: true } as const;
  return {
    keys: new FullscreenPass({
      ...options,
      program: 'distances of particles',
      fragment: 'particleKeys',
      microShaders: { particleKeys },
      uniforms: {
        farol_particlePositions: noTexture(),
        farol_particleVelocities: noTexture(),
        farol_sorted: noTexture(),
        farol_viewRow: { value: new Vector4() },
        farol_sortSlots: { value: new Int32Array(3) },
      },
    }),
    sort: new FullscreenPass({
      ...options,
      program: 'order of particles',
      fragment: 'particleSort',
      microShaders: { particleSort },
      uniforms: { farol_sorted: noTexture(), farol_partners: { value: new Int32Array(3) } },
    }),
  };
}

/**
 * The slots of an emitter's particles from far to near, sorted on the GPU over one or more frames, each from the last frame's
 * order: up to 1024 in one frame, 32,768 in two, 131,072 in three.
 */
export class ParticleOrder {
  private readonly network: ReturnType<typeof sortingNetwork>;
  private readonly targets: [WebGLRenderTarget, WebGLRenderTarget];
  private next = 0;
  private isFresh = true;

  constructor(private readonly slots: number) {
    const bits = Math.max(1, Math.ceil(Math.log2(slots)));
    this.network = sortingNetwork(bits);
    const columns = 2 ** Math.ceil(bits / 2);
    const make = () =>
      new WebGLRenderTarget(columns, 2 ** bits / columns, {
        format: RGFormat,
        type: FloatType,
        minFilter: NearestFilter,
        magFilter: NearestFilter,
        depthBuffer: false,
      });
    this.targets = [make(), make()];
  }

  get bytes(): number {
    return 2 * targetBytes(this.targets[0]);
  }

  /** Distance (m) and slot, RG32F; as many texels as `places`. */
  get texture(): Texture {
    return this.targets[0].texture;
  }

  /** Number of particle slots, rounded up to a power of two, as the sorting network needs. */
  get places(): number {
    return this.targets[0].width * this.targets[0].height;
  }

  /** Sorts the particles by their distance along the view. Binds other targets. */
  sort(frame: Frame, passes: ReturnType<typeof particleSortPasses>, positions: Texture, velocities: Texture): void {
    const { uniforms } = passes.keys;
    const v = frame.camera.matrixWorldInverse.elements;
    uniforms.farol_particlePositions.value = positions;
    uniforms.farol_particleVelocities.value = velocities;
    uniforms.farol_viewRow.value.set(v[2], v[6], v[10], v[14]);
    uniforms.farol_sortSlots.value[0] = this.slots;
    uniforms.farol_sortSlots.value[1] = this.targets[0].width;
    uniforms.farol_sortSlots.value[2] = this.isFresh ? 1 : 0;
    this.isFresh = false;
    this.draw(frame, passes.keys);
    const most = this.places > MANY ? FEW_PASSES : PASSES;
    for (let i = 0; i < Math.min(most, this.network.length); i++) {
      const partners = this.network[this.next];
      passes.sort.uniforms.farol_partners.value.set(partners);
      this.draw(frame, passes.sort);
      this.next = (this.next + 1) % this.network.length;
    }
  }

  dispose(): void {
    for (const target of this.targets) target.dispose();
  }

  private draw(frame: Frame, pass: ReturnType<typeof particleSortPasses>['keys' | 'sort']): void {
    const [now, next] = this.targets;
    pass.uniforms.farol_sorted.value = now.texture;
    pass.drawTo(frame, next);
    this.targets[0] = next;
    this.targets[1] = now;
  }
}
