import type { Object3D } from 'three';
import { Component } from '../core/Component';
import type { GameObject } from '../core/GameObject';
import type { Scene } from '../core/Scene';
import type { SceneChange } from '../core/SceneChange';
import type { SceneSystem } from '../core/SceneSystem';
import { type Channel, FieldChannel, NodeChannel, type NodeProperty } from './Channel';
import type { ClipEvent } from '../assets/clips/ClipData';

/** Interface of components that AnimationSystem plays, such as `Animation`. */
export interface Animated extends Component {
  /** Adds the clips' values at a scene time (s) to the channels. */
  evaluate(time: number): void;
  /**
   * Queues the clip events passed since the last call.
   * @param isCalling - false when the scene was moved to a time: passed events are skipped
   */
  passEvents(time: number, isCalling: boolean): void;
  /** Called after objects, names or components changed: tracks must look up their targets again. */
  targetsChanged(): void;
  /** Called when the scene is reset. */
  resetPlayers(): void;
}

/** Fields whose value decides which further fields a component has: uniforms of a surface, morph targets of a model. */
const CHANGES_FIELDS: ReadonlySet<string> = new Set(['surface', 'model', 'parts']);

/**
 * Plays the animations of a scene: evaluates all clips, blends and applies the channels that they share, then calls
 * events.
 */
export class AnimationSystem implements SceneSystem {
  readonly order = 100;
  private readonly animated: Animated[] = [];
  private readonly fields = new Map<Component, Map<string, FieldChannel>>();
  private readonly nodes = new Map<Object3D, Map<string, NodeChannel>>();
  /** Channels of this frame, the first `shownCount` entries; later entries are left over from older frames. */
  private frameChannels: Channel[] = [];
  private shownCount = 0;
  private shownBefore: Channel[] = [];
  private frame = 0;
  private readonly calls: { host: Component; event: ClipEvent }[] = [];
  /** Counter, raised whenever a clip of the library may have been replaced. */
  clipsRevision = 0;
  private readonly endings: readonly (() => void)[];

  constructor(readonly scene: Scene) {
    this.endings = [
      scene.onChange((change) => this.sceneChanged(change)),
      scene.assets.onChange((change) => {
        if (change.kind !== 'folder' && change.type === 'clip') this.clipsRevision++;
        else if (change.kind === 'loaded') this.clipsRevision++;
      }),
    ];
  }

  add(animated: Animated): void {
    if (!this.animated.includes(animated)) this.animated.push(animated);
  }

  remove(animated: Animated): void {
    const place = this.animated.indexOf(animated);
    if (place >= 0) this.animated.splice(place, 1);
  }

  fieldChannel(component: Component, field: string): Channel {
    let channels = this.fields.get(component);
    if (!channels) this.fields.set(component, (channels = new Map()));
    let channel = channels.get(field);
    if (!channel || channel.isGone) channels.set(field, (channel = new FieldChannel(component, field)));
    return channel;
  }

  nodeChannel(node: Object3D, property: NodeProperty): Channel {
    let channels = this.nodes.get(node);
    if (!channels) this.nodes.set(node, (channels = new Map()));
    let channel = channels.get(property);
    if (!channel) channels.set(property, (channel = new NodeChannel(node, property)));
    return channel;
  }

  /** Prepares a channel for the values of this frame, once per frame. */
  touch(channel: Channel): void {
    if (channel.frame === this.frame) return;
    channel.frame = this.frame;
    channel.begin();
    this.frameChannels[this.shownCount++] = channel;
  }

  /** Queues a clip event; called after all channels of this frame are applied. */
  queueEvent(host: Component, event: ClipEvent): void {
    this.calls.push({ host, event });
  }

  update(deltaSeconds: number, time: number): void {
    const before = this.shownBefore;
    const countBefore = this.shownCount;
    this.shownBefore = this.frameChannels;
    this.frameChannels = before;
    this.shownCount = 0;
    this.frame++;
    const { animated } = this;
    if (time > 0) for (let i = 0; i < animated.length; i++) if (animated[i].isActive) animated[i].evaluate(time);
    for (let i = 0; i < countBefore; i++) {
      const channel = this.shownBefore[i];
      if (channel.frame !== this.frame && !channel.isGone) this.release(channel);
    }
    for (let i = 0; i < this.shownCount; i++) this.apply(this.frameChannels[i]);
    if (time <= 0) return;
    for (let i = 0; i < animated.length; i++) if (animated[i].isActive) animated[i].passEvents(time, deltaSeconds > 0);
    if (this.calls.length > 0) this.callEvents();
  }

  reset(): void {
    for (let i = 0; i < this.shownCount; i++) if (!this.frameChannels[i].isGone) this.frameChannels[i].release();
    this.shownCount = 0;
    this.frameChannels = [];
    this.shownBefore = [];
    this.fields.clear();
    this.nodes.clear();
    this.calls.length = 0;
    for (const each of this.animated) each.resetPlayers();
  }

  dispose(): void {
    for (const end of this.endings) end();
    this.animated.length = 0;
  }

  private apply(channel: Channel): void {
    try {
      channel.apply();
    } catch (error) {
      this.tellOf((channel as FieldChannel).component, error);
    }
  }

  private release(channel: Channel): void {
    try {
      channel.release();
    } catch (error) {
      this.tellOf((channel as FieldChannel).component, error);
    }
    if (channel.users > 0) return;
    if (channel instanceof FieldChannel) this.forget(this.fields, channel.component, channel.field, channel);
    else if (channel instanceof NodeChannel) this.forget(this.nodes, channel.node, channel.property, channel);
  }

  private forget<K, C>(table: Map<K, Map<string, C>>, key: K, name: string, channel: C): void {
    const channels = table.get(key);
    if (channels?.get(name) !== channel) return;
    channels.delete(name);
    if (channels.size === 0) table.delete(key);
  }

  /** Reports an error of a component's animated value; the frame continues. */
  tellOf(component: Component, error: unknown): void {
    if (this.scene.onComponentError) this.scene.reportError(component, error);
    else console.warn(error instanceof Error ? error.message : String(error));
  }

  private callEvents(): void {
    const calls = this.calls.splice(0);
    for (const { host, event } of calls) {
      if (host.isAttached && host.scene === this.scene) this.callMethod(host.gameObject, event);
    }
  }

  /**
   * Calls a method like `GameObject.callMethod`, but an error of one component does not stop the others, and methods of
   * Component itself are not called.
   */
  private callMethod(gameObject: GameObject, { method, value }: ClipEvent): void {
    if (method in Component.prototype) return;
    for (const component of [...gameObject.components]) {
      const found = (component as unknown as Record<string, unknown>)[method];
      if (typeof found !== 'function') continue;
      try {
        if (value === undefined) found.call(component);
        else found.call(component, value);
      } catch (error) {
        this.scene.reportError(component, error);
      }
    }
    for (const child of [...gameObject.children]) this.callMethod(child, { method, value } as ClipEvent);
  }

  private sceneChanged(change: SceneChange): void {
    if (change.kind === 'move' || (change.kind === 'field' && CHANGES_FIELDS.has(change.field)))
      return this.allTargetsChanged();
    const { kind } = change;
    const isName = kind === 'object' && change.property === 'name';
    if (!isName && kind !== 'add' && kind !== 'component-add' && kind !== 'component-class') return;
    const { gameObject } = change;
    for (let each: GameObject | null = gameObject; each; each = each.parent) {
      for (const component of each.components)
        if ('targetsChanged' in component) (component as Animated).targetsChanged();
    }
  }

  private allTargetsChanged(): void {
    for (const each of this.animated) each.targetsChanged();
  }
}
