import { currentOf } from '@farol/editing';
import type { Component } from '../core/Component';
import type { GameObject } from '../core/GameObject';
import type { Scene } from '../core/Scene';
import type { SceneSystem } from '../core/SceneSystem';

interface Caller {
  readonly scene: Scene | null;
  call(event: unknown): void;
}

interface DelayedCall {
  readonly trigger: Caller;
  /** Scene time (s) of the call. */
  readonly due: number;
  readonly event: unknown;
}

/** Pending calls of a scene's EventTriggers, and their switching of objects, which a reset undoes. */
export class TriggerCalls implements SceneSystem {
  readonly order = 50;

  private calls: DelayedCall[] = [];
  private readonly wasActive = new Map<GameObject, boolean>();
  private readonly wasEnabled = new Map<Component, boolean>();

  /** Schedules a trigger's call for scene time `due` (s), even if its object is switched off meanwhile. */
  delay(trigger: Caller, due: number, event: unknown): void {
    this.calls.push({ trigger, due, event });
  }

  setActive(object: GameObject, active: boolean): void {
    if (!this.wasActive.has(object)) this.wasActive.set(object, object.active);
    object.active = active;
  }

  setEnabled(component: Component, enabled: boolean): void {
    if (!this.wasEnabled.has(component)) this.wasEnabled.set(component, component.enabled);
    component.enabled = enabled;
  }

  update(_deltaSeconds: number, time: number): void {
    if (this.calls.length === 0) return;
    const due = this.calls.filter((call) => call.due <= time);
    if (due.length === 0) return;
    this.calls = this.calls.filter((call) => call.due > time);
    for (const { trigger, event } of due.toSorted((a, b) => a.due - b.due)) if (trigger.scene) trigger.call(event);
  }

  reset(): void {
    this.calls = [];
    for (const [component, enabled] of this.wasEnabled) currentOf(component).enabled = enabled;
    for (const [object, active] of this.wasActive) object.active = active;
    this.wasEnabled.clear();
    this.wasActive.clear();
  }

  dispose(): void {
    this.calls = [];
  }
}
