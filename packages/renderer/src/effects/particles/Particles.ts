import { lacksFloatTargets } from '../../gpu/checkDevice';
import type { FarolEffect } from '../../frame/FarolEffect';
import type { Frame } from '../../frame/Frame';
import type { LightLoop } from '../../materials/LightLoop';
import type { EmitterObject, ParticleEmitter } from './ParticleEmitter';
import { particleSortPasses } from './ParticleOrder';
import { ParticleLightingPass, particleLightsPass, particleStepPass } from './particlePasses';
import { ParticleState, type ParticleTextures } from './ParticleState';
import { ParticleSurroundings } from './ParticleSurroundings';
import { SurfaceDepth } from './SurfaceDepth';

/**
 * Simulates and draws the scene's particles: objects of class `ParticleEmitter`. Works with every technique. Emitters
 * are sorted among transparent objects by distance; particles write no depth and cast no shadows. TAA keeps no history
 * of them. Put this effect before others.
 */
export class Particles implements FarolEffect {
  readonly name = 'particles';
  readonly after = ['scene-depth', 'light-lists'] as const;
  readonly lacks = lacksFloatTargets;
  private readonly states = new Map<ParticleEmitter, ParticleState>();
  private readonly drawn: ParticleEmitter[] = [];
  private readonly stepPass = particleStepPass();
  private readonly lightsPass = particleLightsPass();
  private readonly sortPasses = particleSortPasses();
  private readonly lightingPasses = new Map<LightLoop, ParticleLightingPass>();
  private readonly surroundings = new ParticleSurroundings();
  private readonly depth = new SurfaceDepth();
  private loop: LightLoop = 'lightLoopAll';
  private frame: Frame | null = null;

  get bytes(): number {
    let { bytes } = this.depth;
    for (const state of this.states.values()) bytes += state.bytes;
    return bytes;
  }

  /**
   * An emitter's particles as textures of 32-bit floats, a texel each, valid until the next frame; null if it was not drawn yet.
   * Texels with an age of at least their lifetime hold no particle.
   */
  texturesOf(emitter: ParticleEmitter): ParticleTextures | null {
    return this.states.get(emitter)?.textures ?? null;
  }

  begin(frame: Frame): void {
    this.hide(); // hides emitters that an exception left visible in the last frame
    this.frame = frame;
    this.depth.begin();
    this.loop = 'lightLoopAll';
  }

  compute(frame: Frame): void {
    const { webgl } = frame;
    const bound = webgl.getRenderTarget();
    let drew = false;
    this.drawn.length = 0;
    for (const item of frame.queue.transparent) {
      const emitter = item.object as EmitterObject as ParticleEmitter;
      if (emitter.isParticleEmitter !== true) continue;
      const state = this.stateOf(emitter);
      if (state.simulate(frame, this.stepPass)) drew = true;
      if (emitter.lights !== null) {
        state.writeLights(frame, this.lightsPass);
        drew = true;
      }
      if (state.sort(frame, this.sortPasses)) drew = true;
      state.giveTo(item, frame);
      emitter.prepareDraw = this.prepareDraw;
      this.drawn.push(emitter);
    }
    if (!drew) return;
    if (bound === frame.target) frame.bindTarget();
    else webgl.setRenderTarget(bound);
  }

  render(frame: Frame): void {
    const { resources } = frame;
    this.depth.texture = resources.find('scene-depth') ?? null;
    const { z, w } = resources.find('thin-gbuffer')?.target.viewport ?? frame.viewport;
    this.depth.scale.set(z / frame.width, w / frame.height);
    const lists = resources.find('light-lists');
    if (lists === undefined) return;
    // tile lists that were culled by depth may lack lights in front of the opaque surfaces
    const knowsAll = lists.loop !== 'lightLoopTiled' || this.depth.texture === null;
    this.loop = knowsAll ? lists.loop : 'lightLoopAll';
  }

  end(frame: Frame): void {
    const { reactive } = frame;
    if (reactive !== null) {
      for (const item of frame.queue.transparent) {
        const emitter = item.object as EmitterObject as ParticleEmitter;
        if (emitter.isParticleEmitter !== true) continue;
        emitter.prepareDraw = null;
        this.states.get(emitter)?.drawMask(frame, item, reactive);
      }
    }
    this.hide();
  }

  dispose(): void {
    this.hide();
    for (const [emitter, state] of this.states) {
      emitter.removeEventListener('dispose', this.forget);
      state.dispose();
    }
    this.states.clear();
    this.depth.dispose();
    this.surroundings.dispose();
    this.stepPass.dispose();
    this.lightsPass.dispose();
    this.sortPasses.keys.dispose();
    this.sortPasses.sort.dispose();
    for (const pass of this.lightingPasses.values()) pass.dispose();
    this.lightingPasses.clear();
  }

  /** Hides the emitters from three and other renderers after the frame. */
  private hide(): void {
    for (const emitter of this.drawn) {
      emitter.prepareDraw = null;
      emitter.hide();
    }
    this.drawn.length = 0;
    this.frame = null;
  }

  private stateOf(emitter: ParticleEmitter): ParticleState {
    let state = this.states.get(emitter);
    if (state === undefined) {
      this.states.set(emitter, (state = new ParticleState(emitter)));
      emitter.addEventListener('dispose', this.forget);
    }
    return state;
  }

  private readonly forget = ({ target }: { target: unknown }): void => {
    const emitter = target as ParticleEmitter;
    emitter.removeEventListener('dispose', this.forget);
    this.states.get(emitter)?.dispose();
    this.states.delete(emitter);
  };

  /** Called right before an emitter is drawn, when opaque surfaces and light lists exist. */
  private readonly prepareDraw = (emitter: ParticleEmitter): void => {
    const { frame } = this;
    const state = this.states.get(emitter);
    if (frame === null || state === undefined) return;
    if (emitter.softness > 0) state.setDepth(frame, this.depth);
    if (emitter.lit) {
      state.findLight(frame, this.lightingPass(), this.surroundings);
      frame.bindTarget();
    }
    state.touch();
  };

  private lightingPass(): ParticleLightingPass {
    let pass = this.lightingPasses.get(this.loop);
    if (pass === undefined) this.lightingPasses.set(this.loop, (pass = new ParticleLightingPass(this.loop)));
    return pass;
  }
}
