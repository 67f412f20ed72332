import type { FarolEffect, FarolRenderer } from '@farol/renderer';
import type { AmbientOcclusion } from '@farol/renderer/ambient-occlusion';
import type { TAA } from '@farol/renderer/antialiasing';
import type { EffectName } from '@farol/renderer/effects';
import { LateCode } from '../core/LateCode';
import type { SceneSettings } from '../core/SceneSettings';
import { techniqueLimits } from './techniqueLimits';

/** Still frames after which the picture of TAA changes no more. */
const SETTLED = 40;

const late = new LateCode(
  () => import('@farol/renderer/effects'),
  'The code of effects could not be fetched: see that the network is there, and choose one again.',
);

/** Keeps `FarolRenderer.effects` at what a scene asks for; their code is fetched when the first of them is. */
export class PictureEffects {
  /** Effects of plugins, by the names that scenes ask for them by. Call `addedChanged` after a change. */
  readonly added = new Map<string, () => FarolEffect>();

  private asked = false;
  private readonly made = new Map<string, FarolEffect>();
  private current = '';
  private settings: SceneSettings | null = null;
  private revision = -1;
  private technique = '';
  private isSuspended = false;

  /**
   * @param redraw - called when a frame is to be drawn
   * @param failed - called when the code cannot be fetched
   */
  constructor(
    private readonly farol: FarolRenderer,
    private readonly redraw: () => void,
    private readonly failed: (error: unknown) => void,
  ) {}

  /** While techniques are compared, each draws as it does by itself. */
  get suspended(): boolean {
    return this.isSuspended;
  }

  set suspended(suspended: boolean) {
    this.isSuspended = suspended;
    this.refresh();
  }

  /** Frames to draw until a picture that changed is as it stays. */
  get frames(): number {
    return this.settings?.antialiasing === 'taa' && !this.isSuspended ? SETTLED : 1;
  }

  /** Brings the effects up to the settings, and to the technique of the last frame. Those of others in the list stay first. */
  update(settings: SceneSettings): void {
    const { technique } = this.farol.info;
    if (settings === this.settings && settings.revision === this.revision && technique === this.technique) return;
    this.settings = settings;
    this.revision = settings.revision;
    this.technique = technique;
    this.refresh();
  }

  /** Forgets what earlier frames have gathered: the picture has other tones now. */
  forgetFrames(): void {
    (this.made.get('taa') as TAA | undefined)?.reset();
  }

  /** Takes in effects of plugins that came, and gives back those that went. */
  addedChanged(): void {
    this.refresh();
    for (const [name, effect] of this.made) {
      if (this.added.has(name) || (late.code && Object.hasOwn(late.code.effects, name))) continue;
      effect.dispose();
      this.made.delete(name);
    }
  }

  dispose(): void {
    for (const effect of this.made.values()) effect.dispose();
  }

  private refresh(): void {
    const { farol, settings } = this;
    if (settings === null) return;
    farol.antialias = false; // edges are smoothed by what the settings name
    const names = this.isSuspended ? [] : this.wanted(settings);
    const key = names.join();
    if (key !== this.current && late.code === null) {
      this.fetch();
      return;
    }
    if (key !== this.current) {
      this.current = key;
      const own = new Set(this.made.values());
      const others = farol.effects.filter((effect) => !own.has(effect));
      farol.effects = [...others, ...names.map((name) => this.make(name))];
      this.redraw();
    }
    const occlusion = this.made.get('ambient-occlusion') as AmbientOcclusion | undefined;
    if (occlusion === undefined) return;
    occlusion.radius = settings.occlusionRadius;
    occlusion.strength = settings.occlusionStrength;
  }

  private wanted({ ambientOcclusion, unsortedTransparency, pluginEffects, antialiasing }: SceneSettings): string[] {
    const { info, technique, techniques, webgl } = this.farol;
    const names: string[] = [];
    if (ambientOcclusion && !techniqueLimits(techniques, technique).occlusion) names.push('ambient-occlusion');
    if (unsortedTransparency) names.push('order-independent-transparency');
    const asked = namesOf(pluginEffects);
    for (const name of this.added.keys()) if (asked.includes(name)) names.push(name);
    if (antialiasing !== 'auto' && antialiasing !== 'none') names.push(antialiasing);
    const isShaded = techniqueLimits(techniques, info.technique).samples;
    if (antialiasing === 'auto' && isShaded && webgl.getContextAttributes()?.antialias === true) names.push('smaa');
    return names;
  }

  private make(name: string): FarolEffect {
    let effect = this.made.get(name);
    if (effect === undefined) {
      effect = this.added.get(name)?.() ?? late.code!.effects[name as EffectName].make();
      this.made.set(name, effect);
    }
    return effect;
  }

  private fetch(): void {
    if (this.asked) return;
    this.asked = true;
    late.load().then(() => this.refresh(), this.failed);
  }
}

/** The names in a text, which has commas between them. */
export const namesOf = (text: string): string[] =>
  text
    .split(',')
    .map((name) => name.trim())
    .filter(Boolean);
