import type { FarolEffect, FarolRenderer } from '@farol/renderer';
import type { Color, Vector3Tuple } from 'three';
import { LateCode } from '../base/LateCode';
import type { SceneSettings } from '../settings/SceneSettings';
import type { EffectEntry } from '@farol/renderer/effects';
import { effectEntries } from '../settings/effectFields';
import { techniqueAbilities } from './techniqueAbilities';

const entries = Object.entries(effectEntries);

/** Classes of the effects, by key. */
const late = new Map(
  entries.map(([name, { load }]) => [
    name,
    new LateCode(
      load,
      'The code of effects could not be fetched: see that the network is there, and choose one again.',
    ),
  ]),
);

/** Keeps the effects of a scene's settings in `FarolRenderer.effects`; fetches the code of an effect on first use. */
export class PictureEffects {
  /** Factories of plugins' effects, by the names that scenes use. Call `addedChanged` after a change. */
  readonly added = new Map<string, () => FarolEffect>();

  private readonly made = new Map<string, FarolEffect>();
  private names: readonly string[] = [];
  private current = '';
  private settings: SceneSettings | null = null;
  private revision = -1;
  private technique = '';
  private isSuspended = false;

  /**
   * @param redraw - requests a frame
   * @param failed - called when the code cannot be fetched
   */
  constructor(
    private readonly farol: FarolRenderer,
    private readonly redraw: () => void,
    private readonly failed: (error: unknown) => void,
  ) {}

  /** True removes the scene's effects while techniques are compared. */
  get suspended(): boolean {
    return this.isSuspended;
  }

  set suspended(suspended: boolean) {
    this.isSuspended = suspended;
    this.refresh();
  }

  /** Number of frames until a changed picture is final. */
  get frames(): number {
    let frames = 1;
    for (const name of this.names)
      frames = Math.max(frames, this.made.get(name)?.stillFrames ?? effectEntries[name]?.stillFrames ?? 1);
    return frames;
  }

  /**
   * Updates the effects for the settings and the technique of the last frame. Other effects of the renderer stay first
   * in the list.
   */
  update(settings: SceneSettings): void {
    const { technique } = this.farol.info;
    if (settings === this.settings && settings.revision === this.revision && technique === this.technique) return;
    this.settings = settings;
    this.revision = settings.revision;
    this.technique = technique;
    this.refresh();
  }

  /** Sets the scene's time (s) on effects that move with it, such as drifting fog; it stops while nothing plays. */
  setTime(seconds: number): void {
    for (const effect of this.made.values()) if ('time' in effect) effect.time = seconds;
  }

  /** Resets effects that accumulate frames, after a change of tone mapping. */
  forgetFrames(): void {
    for (const effect of this.made.values()) effect.reset?.();
  }

  /** Adds effects of new plugins, and disposes of those of removed ones. */
  addedChanged(): void {
    this.refresh();
    for (const [name, effect] of this.made) {
      if (this.added.has(name) || late.has(name)) continue;
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
    farol.antialias = false; // anti-aliasing is an effect named by the scene's settings
    this.names = this.isSuspended ? [] : this.neededEffects(settings);
    const missing = this.names.flatMap((name) => late.get(name) ?? []).filter(({ code }) => code === null);
    if (missing.length > 0) {
      Promise.all(missing.map((each) => each.load())).then(() => this.refresh(), this.failed);
      return;
    }
    const key = this.names.join();
    if (key !== this.current) {
      this.current = key;
      const own = new Set(this.made.values());
      const others = farol.effects.filter((effect) => !own.has(effect));
      farol.effects = [...others, ...this.names.map((name) => this.make(name))];
      this.redraw();
    }
    for (const [name, effect] of this.made) this.set(effect, effectEntries[name]?.fields ?? {}, settings);
  }

  /** Copies numbers and colours of the settings to an effect. */
  private set(effect: FarolEffect, fields: NonNullable<EffectEntry['fields']>, settings: SceneSettings): void {
    for (const [name, { kind, property }] of Object.entries(fields)) {
      const value = settings.get(name);
      if (kind === 'colour') (Reflect.get(effect, property) as Color).fromArray(value as Vector3Tuple);
      else Reflect.set(effect, property, value);
    }
  }

  private neededEffects(settings: SceneSettings): string[] {
    const { info, technique, techniques, webgl } = this.farol;
    const { pluginEffects, antialiasing } = settings;
    const abilities = techniqueAbilities(techniques, technique);
    const names: string[] = [];
    for (const [name, { setting, needs }] of entries) {
      if (setting !== undefined && settings.get(setting) === true && (!needs || abilities[needs])) names.push(name);
    }
    const asked = namesOf(pluginEffects);
    for (const name of this.added.keys()) if (asked.includes(name)) names.push(name);
    if (antialiasing !== 'auto' && antialiasing !== 'none') names.push(antialiasing);
    const smooths = antialiasing === 'auto' && !techniqueAbilities(techniques, info.technique).samples;
    if (smooths && webgl.getContextAttributes()?.antialias === true) names.push('smaa');
    return names;
  }

  private make(name: string): FarolEffect {
    let effect = this.made.get(name);
    if (effect === undefined) {
      effect = this.added.get(name)?.() ?? new (late.get(name)!.code!)();
      this.made.set(name, effect);
    }
    return effect;
  }
}

/** Splits a text of names at its commas. */
export const namesOf = (text: string): string[] =>
  text
    .split(',')
    .map((name) => name.trim())
    .filter(Boolean);
