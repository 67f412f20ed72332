import { t } from '@farol/editing';
import { type ReactNode, useEffect, useMemo } from 'react';
import { POLAR_RADIUS, polarCurve, RAY_DEGREES, RINGS, roundUp, shinesUp } from '../files/polarCurve';
import { useEditor, useSignal } from './EditorContext';
import './polarCurve.css';

const R = POLAR_RADIUS;
const RADIANS = Math.PI / 180;

const pathOf = (points: readonly (readonly [number, number])[]): string =>
  `M${points.map(([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`).join('L')}`;

/** Text of an intensity (cd), with few digits. */
const candelas = (value: number): string =>
  value >= 100 ? Math.round(value).toString() : Number(value.toPrecision(2)).toString();

/**
 * Rings and rays of a polar diagram, with the rings' intensities.
 * @param scale - intensity (cd) of the outer ring
 * @param isWhole - whether the upper half is shown too
 */
function Grid({ scale, isWhole }: { scale: number; isWhole: boolean }): ReactNode {
  const rings = Array.from({ length: RINGS }, (_, i) => ((i + 1) * R) / RINGS);
  const maximumAngle = isWhole ? 180 : 90;
  const rays: number[] = [];
  for (let angle = -maximumAngle; angle <= maximumAngle; angle += RAY_DEGREES) if (angle > -180) rays.push(angle);
  return (
    <>
      {rings.map((radius) => (
        <path key={radius} className="polar-grid" d={arc(radius, isWhole)} />
      ))}
      {rays.map((angle) => {
        const [x, y] = [Math.sin(angle * RADIANS), Math.cos(angle * RADIANS)];
        return (
          <g key={angle}>
            <path className="polar-grid" d={`M0 0L${x * R} ${y * R}`} />
            <text className="polar-text" x={x * (R + 11)} y={y * (R + 9) + 3}>
              {`${Math.abs(angle)}°`}
            </text>
          </g>
        );
      })}
      {rings
        .filter((_, i) => i % 2 === 1)
        .map((radius) => (
          <text key={radius} className="polar-text polar-ring" x={2} y={radius - 2}>
            {candelas((scale * radius) / R)}
          </text>
        ))}
    </>
  );
}

const arc = (radius: number, isWhole: boolean): string =>
  isWhole
    ? `M0 ${-radius}A${radius} ${radius} 0 1 1 0 ${radius}A${radius} ${radius} 0 1 1 0 ${-radius}`
    : `M${-radius} 0A${radius} ${radius} 0 0 0 ${radius} 0`;

/**
 * Polar diagram of a photometric profile, as in catalogues of luminaires: planes C0 to C180 and C90 to C270 about the
 * vertical axis, with rings of intensity (cd).
 */
export function PolarCurve({ name }: { name: string }): ReactNode {
  const { document } = useEditor();
  useSignal(document.assetsChanged);
  const { assets } = document;
  const isReady = assets.isReady('profile', name);
  const isMissing = !isReady && assets.typeOf(name) === 'profile';
  useEffect(() => {
    // the asset library reports failures
    if (isMissing) void assets.load(name).catch(() => {});
  }, [assets, name, isMissing]);
  const profile = isReady ? assets.profile(name) : null;
  const drawn = useMemo(() => {
    if (!profile) return null;
    const scale = roundUp(profile.maximumIntensity);
    const planes = [90, 0].map((horizontal) => pathOf(polarCurve(profile, horizontal, scale)));
    return { scale, planes, isWhole: shinesUp(profile), flux: profile.luminousFlux };
  }, [profile]);
  if (!profile || !drawn) return null;
  const { scale, planes, isWhole, flux } = drawn;
  const maker = profile.data.keywords.get('MANUFAC');
  const luminaire = profile.data.keywords.get('LUMINAIRE') ?? profile.data.keywords.get('LUMCAT');
  const facts = t('Largest intensity {candelas} cd, luminous flux {lumens} lm', {
    candelas: candelas(profile.maximumIntensity),
    lumens: candelas(flux),
  });
  const [top, height] = isWhole ? [-R - 18, 2 * R + 36] : [-12, R + 30];
  return (
    <figure className="polar-curve">
      <svg
        viewBox={`${-R - 24} ${top} ${2 * R + 48} ${height}`}
        role="img"
        aria-label={`${t('Polar curve of {name}', { name })}. ${facts}`}
      >
        <Grid scale={scale} isWhole={isWhole} />
        <path className="polar-plane polar-cross" d={planes[0]} />
        <path className="polar-plane" d={planes[1]} />
      </svg>
      <figcaption>
        <span className="polar-key">C0 – C180</span>
        <span className="polar-key polar-cross">C90 – C270</span>
        <span>{facts}</span>
        {(maker ?? luminaire) !== undefined && <span>{[maker, luminaire].filter(Boolean).join(' · ')}</span>}
      </figcaption>
    </figure>
  );
}
