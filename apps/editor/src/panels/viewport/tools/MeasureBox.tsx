import { t } from '@farol/editing';
import type { ReactNode } from 'react';
import { useEditor, useSignal } from '../../../ui/EditorContext';
import { lengthText, type MeasureTool } from '../../../viewport/placing/MeasureTool';
import { Button } from '../../../ui/Button';

/** Measured distance, and its components along the axes. */
export function MeasureBox({ tool }: { readonly tool: MeasureTool }): ReactNode {
  const { tools } = useEditor();
  useSignal(tool.changed);
  const { ends } = tool;
  const way = ends && ends[1].clone().sub(ends[0]);
  return (
    <section className="tool-box measure-box" aria-label={t('Measure distance')}>
      <header className="tool-head">
        <strong>{t('Measure distance')}</strong>
      </header>
      {way ? (
        <dl className="measured">
          <dt>{t('Distance')}</dt>
          <dd>{lengthText(way.length())}</dd>
          {(['x', 'y', 'z'] as const).map((axis) => (
            <div key={axis}>
              <dt className={`axis axis-${axis}`}>{axis}</dt>
              <dd>{lengthText(way[axis])}</dd>
            </div>
          ))}
        </dl>
      ) : (
        <p className="tool-note">{t('Click two points. They snap to vertices near the pointer.')}</p>
      )}
      <div className="dialog-buttons">
        <Button label={t('Close')} onClick={() => tools.end(tool)} />
      </div>
    </section>
  );
}
