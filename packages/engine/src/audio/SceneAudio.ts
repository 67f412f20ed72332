import { shortText } from '@farol/editing';
import { Audio, AudioListener, Matrix4, type Object3D, PositionalAudio } from 'three';
import type { Scene } from '../core/Scene';
import type { SceneSystem } from '../core/SceneSystem';
import { tellFault } from '../core/tellFault';
import type { AssetLibrary } from '../assets/AssetLibrary';
import { audioOutput } from './audioOutput';
import type { HearingComponent, HeardSource } from './HeardComponents';

type Playing = Audio | PositionalAudio;

/** Playing sound of one AudioSource. */
interface Voice {
  readonly source: HeardSource;
  readonly audio: Playing;
  readonly buffer: AudioBuffer;
  /** `source.beginning` when this voice started. */
  readonly beginning: number;
  /** `source.revision` when its fields were last copied to the voice. */
  revision: number;
}

/** Moves one of three's audio objects, which is not in the scene, to a world matrix. */
function follow(audio: Object3D, matrix: Matrix4): void {
  audio.matrixWorld.copy(matrix);
  audio.updateMatrixWorld();
}

const origin = new Matrix4();

/** Sets a panner's position at once; afterwards three ramps it from position to position. */
function putAt(panner: PannerNode, { elements }: Matrix4): void {
  if (!panner.positionX) return;
  panner.positionX.value = elements[12];
  panner.positionY.value = elements[13];
  panner.positionZ.value = elements[14];
}

/** Plays the AudioSources of a scene by three's audio. It reads their state in each frame; they do not refer to it. */
export class SceneAudio implements SceneSystem {
  readonly order = 900;

  private listener: AudioListener | null = null;
  private readonly voices = new Map<HeardSource, Voice>();
  /** Sources whose sound cannot be decoded, with the sound's name, so that each is reported once. */
  private readonly reportedSounds = new Map<HeardSource, string>();
  private readonly sources: readonly HeardSource[];
  private readonly listeners: readonly HearingComponent[];
  private volume = -1;

  constructor(private readonly scene: Scene) {
    this.sources = scene.componentsOf<HeardSource>('AudioSource');
    this.listeners = scene.componentsOf<HearingComponent>('AudioListener');
  }

  update(deltaSeconds: number): void {
    const { sources } = this;
    let isPlaying = false;
    for (let i = 0; i < sources.length; i++) {
      const source = sources[i];
      if (source.isPlaying && this.isAtEnd(source)) {
        source.stop();
        // forgotten, not stopped: the end of its sound is still in the output buffer
        this.voices.delete(source);
      }
      isPlaying ||= source.isPlaying;
    }
    this.dropVoices();
    // with `deltaSeconds` 0 the scene was set to a time and does not play on: nothing is to be heard
    if (!isPlaying || deltaSeconds === 0 || !audioOutput.mayBeHeard(this.listener?.context ?? null)) return;
    const listener = (this.listener ??= makeListener());
    if (listener.context.state === 'suspended') listener.context.resume().catch(() => {});
    this.placeListener(listener);
    for (let i = 0; i < sources.length; i++) if (sources[i].isPlaying) this.hear(sources[i], listener);
  }

  /** Silences all voices; the next `update` restarts them at the position for the scene's time. */
  pause(): void {
    for (const source of this.voices.keys()) this.silence(source);
  }

  reset(): void {
    this.pause();
    this.reportedSounds.clear();
  }

  dispose(): void {
    this.reset();
    this.listener?.gain.disconnect();
    this.listener = null;
  }

  /** Whether a source has reached the end of its sound, heard or not. */
  private isAtEnd(source: HeardSource): boolean {
    if (source.loop) return false;
    const buffer = bufferOf(source, this.scene.assets);
    return buffer !== null && source.position >= buffer.duration;
  }

  /** Ends voices of sources that stopped, left the scene, or restarted. */
  private dropVoices(): void {
    for (const [source, { beginning, buffer }] of this.voices) {
      const goesOn = source.isPlaying && source.scene === this.scene && source.beginning === beginning;
      if (!goesOn || bufferOf(source, this.scene.assets) !== buffer) this.silence(source);
    }
  }

  private silence(source: HeardSource): void {
    const voice = this.voices.get(source);
    if (!voice) return;
    this.voices.delete(source);
    if (voice.audio.isPlaying) voice.audio.stop();
    if (voice.audio.source) voice.audio.disconnect();
    voice.audio.gain.disconnect();
  }

  private hear(source: HeardSource, listener: AudioListener): void {
    let voice = this.voices.get(source);
    if (voice && voice.audio instanceof PositionalAudio !== source.positional) {
      this.silence(source);
      voice = undefined;
    }
    if (!voice) {
      const buffer = this.decoded(source);
      if (!buffer) return;
      voice = this.begin(source, buffer, listener);
    } else if (voice.revision !== source.revision) {
      takeFields(voice.audio, source);
      voice.revision = source.revision;
    }
    if (voice.audio instanceof PositionalAudio) follow(voice.audio, source.gameObject.object3D.matrixWorld);
  }

  private begin(source: HeardSource, buffer: AudioBuffer, listener: AudioListener): Voice {
    const audio = source.positional ? new PositionalAudio(listener) : new Audio(listener);
    audio.matrixAutoUpdate = audio.matrixWorldAutoUpdate = false;
    audio.setBuffer(buffer);
    takeFields(audio, source);
    audio.gain.gain.value = source.volume;
    audio.offset = source.position % buffer.duration;
    if (audio instanceof PositionalAudio) putAt(audio.panner, source.gameObject.object3D.matrixWorld);
    audio.play();
    const { beginning, revision } = source;
    const voice: Voice = { source, audio, buffer, beginning, revision };
    this.voices.set(source, voice);
    return voice;
  }

  /** Samples of a source; null while decoding, and when decoding failed, which is reported once. */
  private decoded(source: HeardSource): AudioBuffer | null {
    const { scene } = this;
    const { sound: name } = source;
    const buffer = bufferOf(source, scene.assets);
    if (buffer || name === null || this.reportedSounds.get(source) === name || !scene.assets.isReady('sound', name))
      return buffer;
    this.reportedSounds.set(source, name);
    scene.assets
      .sound(name)
      .decode()
      .catch(({ message }: Error) => {
        if (source.scene === scene) tellFault(source, `It plays '${shortText(name)}', but ${message}`);
      });
    return null;
  }

  private placeListener(listener: AudioListener): void {
    let own: HearingComponent | null = null;
    for (let i = 0; i < this.listeners.length && !own; i++) if (this.listeners[i].isActive) own = this.listeners[i];
    const object = own?.gameObject.object3D ?? this.scene.activeCamera?.three;
    follow(listener, object?.matrixWorld ?? origin);
    const volume = audioOutput.muted ? 0 : (own?.volume ?? 1);
    if (volume === this.volume) return;
    this.volume = volume;
    listener.setMasterVolume(volume);
  }
}

function makeListener(): AudioListener {
  const listener = new AudioListener();
  listener.matrixAutoUpdate = listener.matrixWorldAutoUpdate = false;
  return listener;
}

function bufferOf({ sound }: HeardSource, assets: AssetLibrary): AudioBuffer | null {
  return sound !== null && assets.isReady('sound', sound) ? assets.sound(sound).buffer : null;
}

function takeFields(audio: Playing, source: HeardSource): void {
  audio.setLoop(source.loop);
  audio.setVolume(source.volume);
  audio.setPlaybackRate(source.playbackRate);
  if (!(audio instanceof PositionalAudio)) return;
  audio.setDistanceModel(source.falloff);
  audio.setRefDistance(source.referenceDistance);
  audio.setMaxDistance(Math.max(source.maxDistance, source.referenceDistance + 1e-3));
  audio.setRolloffFactor(source.falloff === 'linear' ? 1 : source.rolloff);
}
