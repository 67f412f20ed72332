export { NodeDraws } from '../../three/NodeDraws';
