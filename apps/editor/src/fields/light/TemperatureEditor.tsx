import { splitColour } from '@farol/editing';
import type { NumberField } from '@farol/engine/fields';
import { colourOfKelvin } from '@farol/engine/photometry';
import type { ReactNode } from 'react';
import type { FieldEditorProps } from '../../api/FieldEditorProps';
import { NumberInput } from '../../ui/NumberInput';
import { Slider } from '../../ui/Slider';
import './light.css';

/** Slider position in perceptually equal steps: mireds (1e6 / K), negated to ascend with temperature. */
const stepsOf = (kelvin: number): number => -1e6 / kelvin;
const kelvinOf = (steps: number): number => Math.round(-1e5 / steps) * 10;

const STOPS = 16;

/** CSS gradient of the colours between two temperatures (K), evenly spaced in mireds. */
function barOf(min: number, max: number): string {
  const [from, to] = [stepsOf(min), stepsOf(max)];
  const colours = Array.from({ length: STOPS }, (_, i) => {
    const steps = from + ((to - from) * i) / (STOPS - 1);
    return splitColour(colourOfKelvin(-1e6 / steps)).hex;
  });
  return `linear-gradient(to right, ${colours.join(', ')})`;
}

/** A colour temperature: a slider over a bar of the light's possible colours, and a number. */
export function TemperatureEditor(props: FieldEditorProps<NumberField>): ReactNode {
  const { field, value, disabled, onPreview, onCommit, onDiscard } = props;
  const { min = 1000, max = 25000, step = 10, unit } = field;
  return (
    <div className="temperature">
      <div className="temperature-bar" style={{ '--temperatures': barOf(min, max) } as React.CSSProperties}>
        <Slider
          value={value === null ? null : stepsOf(value)}
          min={stepsOf(min)}
          max={stepsOf(max)}
          step={0.1}
          disabled={disabled}
          onSlide={(steps) => onPreview(Math.min(max, Math.max(min, kelvinOf(steps))))}
          onEnd={(keeps) => (keeps ? onCommit() : onDiscard())}
        />
      </div>
      <NumberInput
        {...{ ...props, min, max, step, unit }}
        handle={<span className="grip" />}
        scrubsLabel
        onPreview={onPreview}
        onPreviewEach={onPreview}
        onCommit={() => onCommit()}
      />
    </div>
  );
}
