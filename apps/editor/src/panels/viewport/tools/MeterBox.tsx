import { t } from '@farol/editing';
import type { ReactNode } from 'react';
import type { LightMeterTool } from '../../../viewport/illuminance/LightMeterTool';
import { Button } from '../../../ui/Button';
import { useEditor, useSignal } from '../../../ui/EditorContext';

const luxText = (illuminance: number): string => `${Number(illuminance.toPrecision(3))} lx`;
const valueText = (value: number): string => (Number.isFinite(value) ? `${value.toFixed(1)} EV` : '—');

/** The light that was measured last. */
export function MeterBox({ tool }: { readonly tool: LightMeterTool }): ReactNode {
  const { tools } = useEditor();
  useSignal(tool.changed);
  const { reading } = tool;
  return (
    <section className="tool-box measure-box" aria-label={t('Light meter')}>
      <header className="tool-head">
        <strong>{t('Light meter')}</strong>
      </header>
      {reading ? (
        <dl className="measured" role="status">
          <dt>{t('Illuminance')}</dt>
          <dd>{luxText(reading.illuminance)}</dd>
          <dt>{t('Exposure')}</dt>
          <dd>{valueText(reading.value)}</dd>
        </dl>
      ) : (
        <p className="tool-note">{t('Click a surface: the light that falls on it is measured, with all shadows.')}</p>
      )}
      <div className="dialog-buttons">
        <Button label={t('Close')} onClick={() => tools.end(tool)} />
      </div>
    </section>
  );
}
