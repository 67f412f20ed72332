import type { Component } from '../core/Component';

/** Part of AudioSource that SceneAudio reads. */
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
  /** Whether the sound was started and has not ended. */
  readonly isPlaying: boolean;
  /** Playback position in the sound (s); grows beyond the sound's length when looping. */
  readonly position: number;
  /** Number of times that the sound was started or resumed. */
  readonly beginning: number;
  /** Grows when a field gets another value. */
  readonly revision: number;
  stop(): void;
}

/** Part of AudioListener that SceneAudio reads. */
export interface HearingComponent extends Component {
  readonly volume: number;
}
