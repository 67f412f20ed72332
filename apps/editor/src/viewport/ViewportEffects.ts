import type { FarolEffect, FarolInfo, FarolRenderer } from '@farol/renderer';
import type { EffectName } from '@farol/renderer/effects';
import { Registry } from '../model/Registry';

/** Effects that are switched by themselves, in their order in a frame; decals come with the scene. */
export const switchedEffects = ['ambient-occlusion', 'order-independent-transparency'] as const;
export type SwitchedEffect = (typeof switchedEffects)[number];

/** 'auto': the canvas's own multisampling where a technique draws to it, SMAA where it shades a G-buffer. */
export const antialiasings = ['auto', 'none', 'smaa', 'edges', 'taa'] as const;
export type Antialiasing = (typeof antialiasings)[number];

/** What is chosen for the viewport's picture. */
export interface EffectChoice {
  readonly antialiasing: Antialiasing;
  /** Keys of those that are on, those of plugins included; one that is not known has no effect. */
  readonly on: readonly string[];
}

/** An effect of a plugin, as the Frame panel shows it. */
export interface AddedEffect {
  readonly id: string;
  readonly label: string;
  /** One line. */
  readonly help: string;
  /** A new effect, made when it is first switched on. */
  make(): FarolEffect;
}

/** Still frames after which the picture of TAA changes no more. */
const SETTLED = 40;

/** Keeps `FarolRenderer.effects` at what is chosen; their code is fetched when the first of them is on. */
export class ViewportEffects {
  /** Effects of plugins: they come before those that smooth edges. */
  readonly added = new Registry<AddedEffect>('an effect', []);

  private chosen: EffectChoice = { antialiasing: 'auto', on: [] };
  private isSuspended = false;
  private code: typeof import('@farol/renderer/effects') | null = null;
  private asked = false;
  private readonly made = new Map<string, FarolEffect>();
  private current = '';

  /**
   * @param redraw called when a frame is to be drawn
   * @param failed called when the code cannot be fetched
   */
  constructor(
    private readonly farol: FarolRenderer,
    private readonly redraw: () => void,
    private readonly failed: (error: unknown) => void,
  ) {
    this.added.changed.subscribe(() => this.addedChanged());
  }

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

  private addedChanged(): void {
    this.update();
    for (const [name, effect] of this.made) {
      if (name in (this.code?.effects ?? {}) || this.added.get(name)) continue;
      effect.dispose();
      this.made.delete(name);
    }
  }

  private wanted({ passes }: FarolInfo): string[] {
    const { antialiasing, on } = this.chosen;
    if (this.isSuspended) return [];
    const names: string[] = [...switchedEffects, ...this.added.list.map(({ id }) => id)].filter((name) =>
      on.includes(name),
    );
    if (antialiasing !== 'auto' && antialiasing !== 'none') names.push(antialiasing);
    if (antialiasing === 'auto' && passes.some(({ name }) => name === 'g-buffer')) names.push('smaa');
    return names;
  }

  private make(name: string, { effects }: typeof import('@farol/renderer/effects')): FarolEffect {
    let effect = this.made.get(name);
    if (effect === undefined)
      this.made.set(name, (effect = (this.added.get(name) ?? effects[name as EffectName]).make()));
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
