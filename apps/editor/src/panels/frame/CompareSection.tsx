import { t } from '@farol/editing';
import type { TechniqueName } from '@farol/renderer';
import { type ReactNode, useCallback } from 'react';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { FigureList } from '../../ui/FigureList';
import { NumberInput } from '../../ui/NumberInput';
import { SelectBox } from '../../ui/SelectBox';
import { techniqueOptions } from '../../ui/techniqueOptions';
import { Toggle } from '../../ui/Toggle';
import { usePoll } from '../../ui/usePoll';
import { WipePainter } from '../../viewport/painters/WipePainter';
import { Section } from '../inspector/Section';

/** Compares the technique in use with another one: images, difference and measurements. */
export function CompareSection(): ReactNode {
  const editor = useEditor();
  const { viewport, microShaders } = editor;
  useSignal(viewport.changed);
  const { painter } = viewport;
  const wipe = painter instanceof WipePainter ? painter : null;
  const other: TechniqueName = viewport.technique === 'forward-single-pass' ? 'tiled-deferred' : 'forward-single-pass';
  return (
    <Section id="Frame compare" title={t('Compare')} help={t('Two techniques, side by side.')} icon="contrast">
      <div className="field">
        <span className="field-label">{t('Side by side')}</span>
        <Toggle
          value={wipe !== null}
          label={t('Compare two techniques')}
          description={t('The technique in use at the left of the picture, another one at its right.')}
          onChange={(on) =>
            editor.attempt(() => (viewport.painter = on ? new WipePainter(viewport, microShaders, other) : null))
          }
        />
      </div>
      {wipe && <WipeSettings wipe={wipe} />}
    </Section>
  );
}

const psnrText = (psnr: number): string => (Number.isFinite(psnr) ? `${psnr.toFixed(1)} dB` : t('the same'));

function WipeSettings({ wipe }: { wipe: WipePainter }): ReactNode {
  const editor = useEditor();
  const { viewport } = editor;
  useSignal(wipe.changed);
  const { figures } = wipe;
  const times = usePoll(
    useCallback(() => {
      const both = [viewport.farol.info, wipe.other.info];
      // both times are on the GPU, or both on the CPU, so that they can be compared
      const isTimed = both.every(({ gpuMs }) => gpuMs !== null);
      const times = both.map(({ cpuMs, gpuMs }) =>
        isTimed ? `${gpuMs!.toFixed(2)} ms GPU` : `${cpuMs.toFixed(2)} ms CPU`,
      );
      return times.join('\n');
    }, [viewport, wipe]),
    4,
  ).split('\n');
  return (
    <>
      <div className="field">
        <span className="field-label">{t('With')}</span>
        <SelectBox
          value={wipe.technique}
          options={techniqueOptions(viewport.farol)}
          label={t('Technique to compare with')}
          onChange={(technique) => editor.attempt(() => void (wipe.technique = technique))}
        />
      </div>
      <div className="field">
        <span className="field-label">{t('Difference')}</span>
        <Toggle
          value={wipe.showsDifference}
          label={t('Show the difference')}
          description={t('The difference of both pictures in each colour channel, amplified.')}
          onChange={(shows) => (wipe.showsDifference = shows)}
        />
      </div>
      {wipe.showsDifference && (
        <div className="field">
          <span className="field-label">{t('Made larger by')}</span>
          <NumberInput
            value={wipe.gain}
            min={1}
            max={1000}
            step={1}
            label={t('Difference made larger by')}
            handle={<span className="grip" />}
            onPreview={(gain) => (wipe.gain = gain)}
          />
        </div>
      )}
      <FigureList
        className="frame-figures"
        label={t('Difference of the two')}
        figures={[
          ['PSNR', figures === null ? t('measuring') : psnrText(figures.psnr)],
          [t('Largest'), figures === null ? '–' : t('{difference} of 255', { difference: figures.largest.toFixed(1) })],
          [
            t('Off by more than 2'),
            figures === null ? '–' : t('{percent}% of the pixels', { percent: (figures.differing * 100).toFixed(2) }),
          ],
          [t(viewport.farol.techniques[viewport.technique].label), times[0]],
          [t(viewport.farol.techniques[wipe.technique].label), times[1]],
        ]}
      />
    </>
  );
}
