import { formatNumber, t, tCount } from '@farol/editing';
import { type ReactNode, useCallback, useRef } from 'react';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { IconButton } from '../../ui/IconButton';
import { NumberInput } from '../../ui/NumberInput';
import { usePoll } from '../../ui/usePoll';
import type { ParticlePreview } from '../../viewport/particles/ParticlePreview';
import './particleBox.css';

/** Playback controls for the preview of selected emitters; nothing here is an edit. */
export function ParticleBox({ preview }: { readonly preview: ParticlePreview }): ReactNode {
  const { viewport } = useEditor();
  useSignal(preview.changed);
  const kept = useRef(preview.speed);
  const figures = usePoll(
    useCallback(() => {
      const { count, time } = preview;
      const particles = tCount(count, 'up to {count} particle', 'up to {count} particles');
      return `${formatNumber(Math.floor(time * 10) / 10, 'short')} s · ${particles}`;
    }, [preview]),
    5,
  );
  const { emitters } = preview;
  const name = emitters.length === 1 ? emitters[0].gameObject.name : t('{count} emitters', { count: emitters.length });
  const play = preview.isPlaying ? t('Pause the preview') : t('Play the preview');
  return (
    <section className="particle-box" aria-label={t('Preview of particles')}>
      <h2 title={name}>{name}</h2>
      <div className="particle-buttons">
        <IconButton
          icon={preview.isPlaying ? 'pause' : 'play'}
          size={16}
          className="button"
          label={play}
          onClick={() => {
            preview.isPlaying = !preview.isPlaying;
          }}
        />
        <IconButton
          icon="first"
          size={16}
          className="button"
          label={t('Restart the preview')}
          onClick={() => {
            preview.restart();
            viewport.invalidate();
          }}
        />
        <span className="particle-speed" aria-hidden="true">
          {t('Speed')}
        </span>
        <NumberInput
          value={preview.speed}
          min={0}
          max={10}
          step={0.05}
          unit="×"
          digits="short"
          label={t('Speed of the preview')}
          handle={<span className="grip" />}
          onPreview={(speed) => {
            preview.speed = speed;
          }}
          onCommit={() => {
            kept.current = preview.speed;
          }}
          onDiscard={() => {
            preview.speed = kept.current;
          }}
        />
      </div>
      <p className="dim">{figures}</p>
    </section>
  );
}
