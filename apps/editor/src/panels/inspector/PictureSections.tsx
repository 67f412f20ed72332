import { t } from '@farol/editing';
import { effectFields, type SceneSettings } from '@farol/engine';
import { type ReactNode, useMemo, useState } from 'react';
import { allAtDefault } from './atDefault';
import { FieldList } from './FieldList';
import type { IconName } from '../../style/iconPaths';
import { Section } from './Section';
import { TechniqueLimit } from './TechniqueLimit';

const sky = [
  ...[
    'background',
    'backgroundColour',
    'sky',
    'placeSun',
    'sunAzimuth',
    'sunElevation',
    'skyTop',
    'skyHorizon',
    'skyGround',
    'environment',
    'skyLight',
  ],
  ...['environmentIntensity', 'backgroundIntensity', 'backgroundRotation', 'backgroundBlur'],
];
const fog = ['fog', 'fogFromSky', 'fogColour', 'fogNear', 'fogFar', 'fogDensity'];
const picture = [
  ...['technique', 'quality', 'antialiasing', 'frameBudget', 'toneMapping'],
  ...['exposureBy', 'exposure', 'exposureValue', 'aperture', 'shutterTime', 'iso'],
  ...['exposureLeast', 'exposureMost', 'exposureTime'],
  ...Object.keys(effectFields),
];
const shadows = ['shadowKind', 'shadowSoftness', 'shadowCascades'];
const effects = [
  ...['bloom', 'bloomIntensity', 'bloomThreshold', 'bloomRadius'],
  ...['depthOfField', 'focusDistance', 'focusRange', 'focusBlur'],
  ...['grading', 'temperature', 'tint', 'contrast', 'saturation', 'lut', 'lutStrength'],
  ...['vignette', 'vignetteDarkness', 'vignetteSize'],
];

interface SettingsSectionProps {
  readonly id: string;
  readonly title: string;
  readonly help: string;
  readonly icon: IconName;
  readonly settings: SceneSettings;
  readonly names: readonly string[];
  readonly children?: ReactNode;
}

/** A section of the scene's settings, folded at first when all settings in it have their defaults. */
export function SettingsSection({ settings, names, children, ...section }: SettingsSectionProps): ReactNode {
  const owners = useMemo(() => [settings], [settings]);
  const [isFoldedAtFirst] = useState(() => allAtDefault(settings, names));
  return (
    <Section {...section} isFoldedAtFirst={isFoldedAtFirst}>
      <FieldList owners={owners} names={names} />
      {children}
    </Section>
  );
}

/** Sections of the rendering settings, in order. */
const sections = () =>
  [
    {
      id: 'Sky',
      title: t('Sky'),
      help: t('The background, and the light from it.'),
      icon: 'world',
      names: sky,
    },
    { id: 'Fog', title: t('Fog'), help: t('How objects fade with distance.'), icon: 'world', names: fog },
    { id: 'Picture', title: t('Picture'), help: t('How light becomes a picture.'), icon: 'contrast', names: picture },
    {
      id: 'Shadows',
      title: t('Shadows'),
      help: t('How the shadows of all lights are drawn.'),
      icon: 'contrast',
      names: shadows,
    },
    {
      id: 'Picture effects',
      title: t('Picture effects'),
      help: t('Effects on the finished picture.'),
      icon: 'contrast',
      names: effects,
    },
  ] as const;

/** Rendering settings of the scene. A feature that is off shows only its switch. */
export function PictureSections({ settings }: { settings: SceneSettings }): ReactNode {
  return sections().map((section) => (
    <SettingsSection key={section.id} settings={settings} {...section}>
      {section.id === 'Picture' && <TechniqueLimit settings={settings} />}
    </SettingsSection>
  ));
}
