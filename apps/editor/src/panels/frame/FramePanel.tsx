import { formatCount, t } from '@farol/editing';
import { type ReactNode, useCallback } from 'react';
import { FigureList } from '../../ui/FigureList';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { SelectBox } from '../../ui/SelectBox';
import { techniqueOptions } from '../../ui/techniqueOptions';
import { usePoll } from '../../ui/usePoll';
import { viewOptions } from '../../ui/viewOptions';
import '../inspector/inspector.css';
import { Section } from '../inspector/Section';
import { CompareSection } from './CompareSection';
import { EffectsSection } from './EffectsSection';
import './frame.css';
import { PassesSection } from './PassesSection';
import { ViewsSection } from './ViewsSection';

const megabytes = (bytes: number): string => `${(bytes / 2 ** 20).toFixed(1)} MB`;

/** Settings and measurements of rendering: technique, debug view, times of passes, comparison of techniques. */
export function FramePanel(): ReactNode {
  const editor = useEditor();
  const { viewport } = editor;
  useSignal(viewport.changed);
  return (
    <section className="panel" aria-label={t('Frame')}>
      <div className="inspector-body">
        <Section
          id="Frame"
          title={t('Technique')}
          help={t('The technique that draws the picture, and the view of it.')}
          icon="lamp"
        >
          <div className="field">
            <span className="field-label">{t('Technique')}</span>
            <SelectBox
              value={viewport.technique}
              options={techniqueOptions(viewport.farol)}
              label={t('Technique of the frame')}
              onChange={(technique) => editor.attempt(() => void (viewport.technique = technique))}
            />
          </div>
          <div className="field">
            <span className="field-label">{t('View')}</span>
            <SelectBox
              value={viewport.view}
              options={viewOptions()}
              label={t('View of the frame')}
              onChange={(view) => editor.attempt(() => void (viewport.view = view))}
            />
          </div>
          <Figures />
        </Section>
        <PassesSection />
        <EffectsSection />
        <ViewsSection />
        <CompareSection />
      </div>
    </section>
  );
}

/** Counts of the last frame, and the technique that was used with the reason for it. */
function Figures(): ReactNode {
  const { viewport } = useEditor();
  const text = usePoll(
    useCallback(() => {
      const { info } = viewport.farol;
      if (info.technique === '') return '';
      const { label } = viewport.farol.techniques[info.technique];
      return [
        viewport.technique === 'auto' ? `${t(label)}: ${t(info.reason)}.` : '',
        info.budget === null
          ? ''
          : `${t('Scale')}\t${(100 * info.budget.scale).toFixed(0)} %: ${t(info.budget.reason)}`,
        `${t('Lights')}\t${t('{visible} of {total} in view', { visible: info.lights.visible, total: info.lights.total })}`,
        `${t('Draws')}\t${formatCount(info.drawCalls)}`,
        `${t('Triangles')}\t${formatCount(info.triangles)}`,
        `${t('Programs')}\t${info.programs}`,
        `${t('Targets')}\t${megabytes(info.targetBytes)}`,
        `${t('Sent')}\t${t('{kilobytes} kB a frame', { kilobytes: (info.uploadBytes / 1024).toFixed(1) })}`,
      ].join('\n');
    }, [viewport]),
    4,
  );
  const [reason, ...figures] = text.split('\n');
  return (
    <>
      {reason && (
        <p className="frame-reason" aria-label={t('Why this technique')}>
          {reason}
        </p>
      )}
      <FigureList className="frame-figures" figures={figures.map((line) => line.split('\t') as [string, string])} />
    </>
  );
}
