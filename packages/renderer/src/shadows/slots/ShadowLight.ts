import type {
  DirectionalLight,
  LightShadow,
  OrthographicCamera,
  PerspectiveCamera,
  PointLight,
  SpotLight,
} from 'three';

/** Lights that cast shadows in three. */
export type ShadowLight = (PointLight | SpotLight | DirectionalLight) & {
  isPointLight?: boolean;
  isSpotLight?: boolean;
};

/** Camera of a light's shadow, perspective or orthographic. */
export type ShadowCamera = PerspectiveCamera & OrthographicCamera;

/** three's LightShadow with methods that three's types leave out. */
export type PrivateLightShadow = LightShadow & { updateMatrices(light: ShadowLight): void };
