import type { Component } from '../core/Component';

/** What is read of an AudioSource to make it heard. */
export interface HeardSource extends Component {
  readonly sound: string | null;
  readonly loop: boolean;
  readonly volume: number;
  readonly playbackRate: number;
  readonly positional: boolean;
  readonly falloff: DistanceModelType;
  readonly referenceDistance: number;
  readonly maxDistance: number;
  readonly rolloff: number;
  /** Whether it was told to play, and is not at its end. */
  readonly isPlaying: boolean;
  /** Where in the sound it is (s); beyond its length where it loops. */
  readonly position: number;
  /** How often it began. */
  readonly beginning: number;
  /** Grows when a field gets another value. */
  readonly revision: number;
  stop(): void;
}

/** What is read of an AudioListener. */
export interface HearingComponent extends Component {
  readonly volume: number;
}
