import { t } from '@farol/editing';
import type { ReactNode } from 'react';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { NumberInput } from '../../ui/NumberInput';
import { Toggle } from '../../ui/Toggle';
import { ViewsPainter } from '../../viewport/painters/ViewsPainter';
import { Section } from '../inspector/Section';

/** Switches the grid of all debug views, and sets the scale of heat maps (number of lights, overdraw). */
export function ViewsSection(): ReactNode {
  const editor = useEditor();
  const { viewport } = editor;
  useSignal(viewport.changed);
  const isOn = viewport.painter instanceof ViewsPainter;
  const setMaximum = (value: number): void => viewport.setHeatMapMaximum(value);
  return (
    <Section id="Frame views" title={t('Views')} help={t('Everything that the frame is made of.')} icon="grid">
      <div className="field">
        <span className="field-label">{t('All views at once')}</span>
        <Toggle
          value={isOn}
          label={t('All views at once')}
          description={t('Views of surfaces, light and counts beside one another; a click on one shows it alone.')}
          onChange={(on) => editor.attempt(() => void (viewport.painter = on ? new ViewsPainter(viewport) : null))}
        />
      </div>
      <div className="field">
        <span className="field-label">{t('Heat map maximum')}</span>
        <NumberInput
          value={viewport.farol.heatMapMaximum}
          min={1}
          max={1024}
          step={1}
          label={t('Heat map maximum')}
          description={t('Lights, or draws, a pixel at which light count and overdraw are red.')}
          handle={<span className="grip" />}
          onPreview={setMaximum}
        />
      </div>
    </Section>
  );
}
