import type { FarolEffect, FarolInfo, FarolRenderer } from '@farol/renderer';
import type { EffectName } from '@farol/renderer/effects';

/** Effects that are switched by themselves, in their order in a frame; decals come with the scene. */
export const switchedEffects = ['ambient-occlusion', 'order-independent-transparency'] as const;
export type SwitchedEffect = (typeof switchedEffects)[number];

/** 'auto': the canvas's own multisampling where a technique draws to it, SMAA where it shades a G-buffer. */
export const antialiasings = ['auto', 'none', 'smaa', 'edges', 'taa'] as const;
export type Antialiasing = (typeof antialiasings)[number];

/** What is chosen for the viewport's picture. */
export interface EffectChoice {
  readonly antialiasing: Antialiasing;
  readonly on: readonly SwitchedEffect[];
}

/** Still frames after which the picture of TAA changes no more. */
const SETTLED = 40;

/** Keeps `FarolRenderer.effects` at what is chosen; their code is fetched when the first of them is on. */
export class ViewportEffects {
  private chosen: EffectChoice = { antialiasing: 'auto', on: [] };
  private isSuspended = false;
  private code: typeof import('@farol/renderer/effects') | null = null;
  private asked = false;
  private readonly made = new Map<EffectName, FarolEffect>();
  private current = '';

  /**
   * @param redraw called when a frame is to be drawn
   * @param failed called when the code cannot be fetched
   */
  constructor(
    private readonly farol: FarolRenderer,
    private readonly redraw: () => void,
    private readonly failed: (error: unknown) => void,
  ) {}

  get choice(): EffectChoice {
    return this.chosen;
  }

  set choice(choice: EffectChoice) {
    if (choice === this.chosen) return;
    this.chosen = choice;
    this.update();
    this.redraw();
  }

  /** While techniques are compared, each draws as it does by itself. */
  set suspended(suspended: boolean) {
    this.isSuspended = suspended;
    this.update();
  }

  /** Frames to draw until a picture that changed is as it stays. */
  get frames(): number {
    return this.chosen.antialiasing === 'taa' ? SETTLED : 1;
  }

  /** After a frame: brings the effects up to the choice and to its technique. Those of others in the list stay first. */
  update(): void {
    const { farol, code } = this;
    const names = this.wanted(farol.info);
    if (names.join() === this.current) return;
    if (code === null) {
      this.fetch();
      return;
    }
    this.current = names.join();
    const own = new Set(this.made.values());
    const others = farol.effects.filter((effect) => !own.has(effect));
    farol.effects = [...others, ...names.map((name) => this.make(name, code))];
    this.redraw();
  }

  dispose(): void {
    for (const effect of this.made.values()) effect.dispose();
  }

  private wanted({ passes }: FarolInfo): EffectName[] {
    const { antialiasing, on } = this.chosen;
    if (this.isSuspended) return [];
    const names: EffectName[] = switchedEffects.filter((name) => on.includes(name));
    if (antialiasing !== 'auto' && antialiasing !== 'none') names.push(antialiasing);
    if (antialiasing === 'auto' && passes.some(({ name }) => name === 'g-buffer')) names.push('smaa');
    return names;
  }

  private make(name: EffectName, { effects }: typeof import('@farol/renderer/effects')): FarolEffect {
    let effect = this.made.get(name);
    if (effect === undefined) this.made.set(name, (effect = effects[name].make()));
    return effect;
  }

  private fetch(): void {
    if (this.asked) return;
    this.asked = true;
    import('@farol/renderer/effects').then((code) => {
      this.code = code;
      this.update();
    }, this.failed);
  }
}
