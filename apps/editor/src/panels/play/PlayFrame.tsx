import { t } from '@farol/editing';
import { TouchControls } from '@farol/engine';
import { type ReactNode, useEffect, useRef } from 'react';
import { play } from '../../actions/play';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { Icon } from '../../ui/Icon';
import { isTouchScreen } from '../../viewport/isTouchScreen';
import { keyText } from '../../ui/keyText';
import { useSoundWaits } from '../../ui/useAudioOutput';
import { useKeyBindings } from '../../ui/useKeyBindings';
import { XRButtons } from './XRButtons';
import './playFrame.css';

/** Frame around the viewport while the scene plays or is paused, with a note that Stop undoes edits. */
export function PlayFrame(): ReactNode {
  const { viewport, document } = useEditor();
  const { simulation } = document;
  useSignal(simulation.changed);
  useSignal(viewport.changed);
  const place = useRef<HTMLDivElement>(null);
  const key = useKeyBindings().keysOf(play).at(0);
  const soundWaits = useSoundWaits();
  const { state } = simulation;
  const isLed = viewport.lookThrough !== null && state === 'playing';
  useEffect(() => {
    if (!isLed) return undefined;
    const controls = new TouchControls(viewport.canvas, place.current!, () => document.scene, t('Jump'));
    return () => controls.dispose();
  }, [isLed, viewport, document]);
  if (state === 'stopped') return null;
  const keys = key ? keyText(key) : t('The stop button');
  return (
    <div ref={place} className="play-frame" data-state={state}>
      <p role="status">
        <Icon name={state === 'playing' ? 'play' : 'pause'} size={12} />
        <strong>{state === 'playing' ? t('Playing') : t('Paused')}</strong>
        <span className="play-frame-help">
          {isTouchScreen()
            ? t('Tap Stop to put everything back')
            : state === 'playing'
              ? t('{keys} stops and puts everything back', { keys })
              : t('Stop puts everything back; {keys} plays on', { keys })}
        </span>
        <XRButtons />
        {soundWaits && <span>{t('Click for sound')}</span>}
      </p>
    </div>
  );
}
