import { t } from '@farol/editing';
import type { Sound } from '@farol/engine';
import { type ReactNode, useEffect, useState } from 'react';
import { soundPreview } from '../files/soundPreview';
import { useEditor, useSignal } from './EditorContext';
import { IconButton } from './IconButton';

/** Duration as text: '0.7 s', '3:05'. */
export const lengthText = (seconds: number): string =>
  seconds < 60
    ? `${seconds.toFixed(1)} s`
    : `${Math.floor(seconds / 60)}:${String(Math.floor(seconds % 60)).padStart(2, '0')}`;

/** Button that plays and pauses a sound of the library, and shows its duration. */
export function SoundButton({ name }: { name: string }): ReactNode {
  const editor = useEditor();
  const { assets } = editor.document;
  useSignal(soundPreview.changed);
  const [seconds, setSeconds] = useState<number | null>(null);
  const sound: Sound | null = assets.isReady('sound', name) ? assets.sound(name) : null;
  useEffect(() => {
    let isCurrent = true;
    // decoding errors are shown when the sound is played
    sound?.decode().then(
      (buffer) => isCurrent && setSeconds(buffer?.duration ?? null),
      () => {},
    );
    return () => {
      isCurrent = false;
      if (sound && soundPreview.playing === sound) soundPreview.hold();
    };
  }, [sound]);
  const isPlaying = sound !== null && soundPreview.playing === sound;
  const play = async (): Promise<void> => {
    await assets.load(name);
    await soundPreview.toggle(assets.sound(name)).catch(({ message }: Error) => {
      throw new Error(t("'{name}' cannot be played: {reason}", { name, reason: message }));
    });
  };
  const label = isPlaying ? t('Pause {name}', { name }) : t('Play {name}', { name });
  return (
    <span className="sound-button">
      <IconButton icon={isPlaying ? 'pause' : 'play'} label={label} onClick={() => editor.attempt(play)} />
      {seconds !== null && <span>{lengthText(seconds)}</span>}
    </span>
  );
}
