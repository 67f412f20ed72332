export function projectedSphereBounds(_x:number,_y:number,_z:number,_r:number,_m:any,out:any){ out[0]=-1;out[1]=-1;out[2]=1;out[3]=1; return true; }
