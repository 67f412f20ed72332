import type { Vector3 } from 'three';
import type { GameObject } from './GameObject';

/** A pointer event as components see it; positions in CSS pixels from the canvas's top left corner. */
export interface EnginePointerEvent {
  /** 'leave': the pointer left the canvas, or its gesture was cancelled. */
  readonly type: 'down' | 'move' | 'up' | 'wheel' | 'leave';
  readonly x: number;
  readonly y: number;
  /** Movement since the last event, in CSS pixels. */
  readonly dx: number;
  readonly dy: number;
  /** Normalised device coordinates, -1 to 1, y up. */
  readonly ndcX: number;
  readonly ndcY: number;
  /** The button that changed: 0 left, 1 middle, 2 right, -1 none. */
  readonly button: number;
  /** Bit mask of the buttons held: 1 left, 2 right, 4 middle. */
  readonly buttons: number;
  readonly pointerId: number;
  /** Kind of pointer; a mouse when absent. */
  readonly pointerType?: 'mouse' | 'touch' | 'pen';
  /** Wheel movement in CSS pixels, positive towards the user; 0 for other types. */
  readonly wheel: number;
  readonly shiftKey: boolean;
  readonly ctrlKey: boolean;
  readonly altKey: boolean;
  readonly metaKey: boolean;
}

/** A keyboard event as components see it. */
export interface EngineKeyEvent {
  readonly type: 'down' | 'up';
  /** Physical key, such as 'KeyW' or 'ArrowUp' (KeyboardEvent.code). */
  readonly code: string;
  /** Character that the key types, such as 'w'. */
  readonly key: string;
  readonly repeat: boolean;
  readonly shiftKey: boolean;
  readonly ctrlKey: boolean;
  readonly altKey: boolean;
  readonly metaKey: boolean;
}

/** Pointer event for components of the object under the pointer, and of its ancestors. */
export interface ObjectPointerEvent extends EnginePointerEvent {
  /** Object under the pointer; in `onPointerOut` the object that the pointer has left. */
  readonly target: GameObject;
  /** Point under the pointer on `target`, in world space (m). */
  readonly point: Vector3;
  /** Distance from the camera to `point` (m). */
  readonly distance: number;
  /** Stops the event from reaching ancestors of the called object. */
  stopPropagation(): void;
}

/** Kinds of events that cost time to detect, and are detected only for components that want them. */
export type CostlyEvents = 'pointer' | 'key';
