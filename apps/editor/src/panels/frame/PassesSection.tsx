import { t } from '@farol/editing';
import { type ReactNode, useCallback, useEffect, useMemo, useRef, useState } from 'react';
import { continuous } from '../../actions/display';
import { ActionButton } from '../../ui/ActionButton';
import { useEditor } from '../../ui/EditorContext';
import { usePoll } from '../../ui/usePoll';
import { FrameRecorder } from '../../viewport/FrameRecorder';
import { Section } from '../inspector/Section';
import { drawPassGraph, passColour } from './drawPassGraph';
import { Button } from '../../ui/Button';

type Kind = 'cpu' | 'gpu';

const ms = (value: number | null): string => (value === null ? '–' : value.toFixed(value < 10 ? 2 : 1));

/** Stacked graph of the times of passes over the last frames, and a table of their means. */
export function PassesSection(): ReactNode {
  const { viewport } = useEditor();
  const recorder = useMemo(() => new FrameRecorder(), []);
  const canvas = useRef<HTMLCanvasElement>(null);
  const [chosen, setChosen] = useState<Kind | null>(null);
  const hasGpu = viewport.farol.info.gpuMs !== null;
  const kind = chosen ?? (hasGpu ? 'gpu' : 'cpu');

  useEffect(() => {
    const draw = (): void => (canvas.current === null ? undefined : drawPassGraph(canvas.current, recorder, kind));
    draw();
    const endings = [
      viewport.drawn.subscribe(() => {
        recorder.add(viewport.farol.info);
        draw();
      }),
      viewport.timed.subscribe(() => {
        recorder.addTimes(viewport.farol.info);
        draw();
      }),
    ];
    return () => endings.forEach((end) => end());
  }, [viewport, recorder, kind]);

  // an idle viewport draws one frame, so that there are times to show
  useEffect(() => viewport.invalidate(), [viewport]);

  const rows = usePoll(
    useCallback(() => {
      const now = new Map(viewport.farol.info.passes.map((pass) => [pass.name, pass]));
      return recorder.passes
        .filter(({ name }) => now.has(name))
        .map((times) => {
          const pass = now.get(times.name)!;
          const [cpu, gpu] = (['cpu', 'gpu'] as const).map((each) => ms(recorder.mean(times, each)));
          return [times.name, pass.drawCalls, cpu, gpu].join('\t');
        })
        .join('\n');
    }, [viewport, recorder]),
    4,
  );

  return (
    <Section
      id="Frame passes"
      title={t('Passes')}
      help={t('Time of each pass over the last 120 frames.')}
      icon="motion"
      controls={
        <div className="button-group" role="group" aria-label={t('Times of')}>
          {(['cpu', 'gpu'] as const).map((each) => (
            <Button
              look="small"
              label={each.toUpperCase()}
              key={each}
              aria-pressed={kind === each}
              disabled={each === 'gpu' && !hasGpu}
              onClick={() => setChosen(each)}
            />
          ))}
          <ActionButton action={continuous} />
        </div>
      }
    >
      <canvas
        ref={canvas}
        className="pass-graph"
        role="img"
        aria-label={t('{processor} time of each pass over the last frames; the means are in the table below', {
          processor: kind.toUpperCase(),
        })}
      />
      <table className="pass-table">
        <thead>
          <tr>
            <th scope="col">{t('Pass')}</th>
            <th scope="col">{t('Draws')}</th>
            <th scope="col">CPU ms</th>
            <th scope="col">GPU ms</th>
          </tr>
        </thead>
        <tbody>
          {rows !== '' &&
            rows.split('\n').map((row) => {
              const [name, ...figures] = row.split('\t');
              return (
                <tr key={name}>
                  <th scope="row">
                    <span className="pass-mark" style={{ background: passColour(name) }} />
                    {name}
                  </th>
                  {figures.map((figure, i) => (
                    // oxlint-disable-next-line react/no-array-index-key -- the columns have fixed places
                    <td key={i}>{figure}</td>
                  ))}
                </tr>
              );
            })}
        </tbody>
      </table>
    </Section>
  );
}
