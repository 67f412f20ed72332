import { t } from '@farol/editing';
import { useSignal, useEditor } from '../../../ui/EditorContext';
import { Button } from '../../../ui/Button';
import { Color, SRGBColorSpace } from 'three';
import type { ReactNode } from 'react';
import { lengthText } from '../../../viewport/placing/MeasureTool';
import type { PixelLightingTool } from '../../../viewport/pixelLighting/PixelLightingTool';
import type { PixelReading, ShareLine } from '../../../viewport/pixelLighting/PixelReading';
import './pixelBox.css';

/** CSS colour with the hue of a light's colour at full brightness, so that dim light is recognizable. */
function screenColour(color: Color): string {
  const brightest = Math.max(color.r, color.g, color.b, 1e-9);
  const shown = color.clone().multiplyScalar(1 / Math.max(brightest, 1e-9));
  return Math.min(color.r, color.g, color.b) < 0 || brightest <= 1e-9 ? 'transparent' : shown.getStyle(SRGBColorSpace);
}

const percent = (part: number): string =>
  part > 0 && part < 0.0005 ? '< 0.1 %' : `${Number((part * 100).toFixed(1))} %`;

const linear = ({ r, g, b }: Color): string => [r, g, b].map((value) => value.toFixed(3)).join(' ');

/** The lights that reach a pixel, other parts of its colour, and the object drawn there. */
export function PixelBox({ tool }: { readonly tool: PixelLightingTool }): ReactNode {
  const { tools, viewport } = useEditor();
  useSignal(tool.changed);
  const { reading, progress } = tool;
  const isBusy = progress !== null;
  return (
    <section className="tool-box pixel-box" aria-label={t('Explain a pixel')} aria-busy={isBusy}>
      <header className="tool-head">
        <strong>{t('Explain a pixel')}</strong>
      </header>
      {isBusy && <progress value={progress} max={1} aria-label={t('Lights are drawn one by one')} />}
      {reading ? (
        <Reading reading={reading} />
      ) : (
        <p className="tool-note">
          {t('Click the picture: the lights that make the pixel are listed, brightest first.')}
        </p>
      )}
      <div className="dialog-buttons">
        {isBusy ? (
          <Button label={t('Cancel')} onClick={() => tool.cancel()} />
        ) : (
          <Button
            label={t('Explain the middle')}
            onClick={() => void tool.explainMiddle().catch((error) => viewport.onError(error))}
          />
        )}
        <Button label={t('Close')} onClick={() => tools.end(tool)} />
      </div>
    </section>
  );
}

function Reading({ reading }: { readonly reading: PixelReading }): ReactNode {
  const { lighting, lights, others, surfaces } = reading;
  const { technique, effectsLeftOut, changed, programs } = lighting;
  const { viewport } = useEditor();
  return (
    <div className="tool-fields pixel-reading">
      <p className="pixel-sum" role="status">
        <Swatch color={lighting.color} />
        <span title={t('Linear RGB, before exposure and tone mapping')}>{linear(lighting.color)}</span>
        <span className="pixel-technique">{t(viewport.farol.techniques[technique].label)}</span>
      </p>
      <table className="pixel-lights">
        <thead>
          <tr>
            <th scope="col">{t('Light')}</th>
            <th scope="col" title={t('Share of all light that reaches the pixel')}>
              {t('Share')}
            </th>
            <th scope="col" title={t('What the share would be if nothing cast a shadow in this light')}>
              {t('Unshadowed')}
            </th>
            <th scope="col">{t('Distance')}</th>
            <th scope="col" title={t('Estimated share of the lighting time of the picture')}>
              {t('Cost')}
            </th>
          </tr>
        </thead>
        <tbody>
          {[...lights, ...others].map((line) => (
            <Line key={line.key} line={line} />
          ))}
        </tbody>
      </table>
      {lights.length + others.length === 0 && <p className="tool-note">{t('No light reaches this pixel.')}</p>}
      {surfaces.length > 0 && <Surfaces surfaces={surfaces} />}
      {effectsLeftOut.length > 0 && (
        <p className="tool-note">
          {t('Without effects that need the whole picture: {names}', { names: effectsLeftOut.join(', ') })}
        </p>
      )}
      {changed && <p className="tool-note">{t('The picture changed meanwhile: the shares are of different times.')}</p>}
      <details className="pixel-chunks">
        <summary>{t('Microshaders that ran')}</summary>
        <dl>
          {programs.map(({ name, microshaders }, i) => (
            <div key={i}>
              <dt>{name}</dt>
              <dd>{microshaders.join(', ') || '—'}</dd>
            </div>
          ))}
        </dl>
      </details>
    </div>
  );
}

const Swatch = ({ color }: { readonly color: Color }): ReactNode => (
  <span className="pixel-swatch" style={{ background: screenColour(color) }} aria-hidden="true" />
);

function Line({ line }: { readonly line: ShareLine }): ReactNode {
  const { document } = useEditor();
  useSignal(document.selection.changed);
  const { name, object, color, share, unshadowed, unshadowedColor, distance, cost } = line;
  const isSelected = object !== null && document.selection.has(object.id);
  return (
    <tr className={isSelected ? 'selected' : undefined}>
      <th scope="row">
        <Swatch color={color} />
        {object ? (
          <button
            type="button"
            className="pixel-name one-line"
            aria-pressed={isSelected}
            onClick={() => document.selection.set([object.id])}
          >
            {name}
          </button>
        ) : (
          <span className="pixel-name one-line">{name}</span>
        )}
      </th>
      <td title={linear(color)}>{percent(share)}</td>
      <td title={unshadowedColor ? linear(unshadowedColor) : undefined}>
        {unshadowed === null ? '' : percent(unshadowed)}
      </td>
      <td>{distance === null ? '' : lengthText(distance)}</td>
      <td>{cost === null ? '' : percent(cost)}</td>
    </tr>
  );
}

function Surfaces({ surfaces }: Pick<PixelReading, 'surfaces'>): ReactNode {
  const { document } = useEditor();
  return (
    <div className="tool-part pixel-surfaces">
      {surfaces.map(({ key, object, material }) => (
        <div key={key} className="pixel-surface">
          <Button
            look="small framed"
            icon="body"
            label={object.name}
            onClick={() => document.selection.set([object.id])}
          />
          <Button
            look="small framed"
            icon="decal"
            label={material === null ? t('Its own material') : material}
            onClick={() =>
              material === null ? document.selection.set([object.id]) : document.assetSelection.set([material])
            }
          />
        </div>
      ))}
    </div>
  );
}
