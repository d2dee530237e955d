//! Bytes → rays. Bytes may come from anywhere: nothing is taken for granted, and no more memory is used than a small
//! multiple of their number.

use super::error::RayFileError;
use super::{
    ANY, CLOSEST, ClassRays, ENTRY, HEADER, Hash, MAGIC, RAY, RAYS_PER_CALL, RayAnswers, RayFile,
    VERSION,
};
use crate::math::{Hit, Ray};
use crate::record::RayClass;
use crate::sealed::{self, u32_at, u64_at};
use glam::Vec3;

impl RayFile {
    /// Reads the bytes of a file. Every ray is in the range of [`Ray`], and every answer is one that a ray can have.
    ///
    /// # Errors
    /// If the bytes are no such file, or are not all of it, or were altered.
    pub fn decode(bytes: &[u8]) -> Result<Self, RayFileError> {
        if !bytes.starts_with(&MAGIC) {
            return Err(RayFileError::Magic);
        }
        let found = bytes.len() as u64;
        let short = |expected: usize| RayFileError::Length { expected: expected as u64, found };
        let least = HEADER + size_of::<Hash>();
        let header = bytes.get(..HEADER).ok_or_else(|| short(least))?;
        let version = u32_at(header, 8);
        if version != VERSION {
            return Err(RayFileError::Version { found: version });
        }
        let count = u32_at(header, 12) as usize;
        let behind_table = count.checked_mul(ENTRY).and_then(|table| table.checked_add(HEADER));
        let behind_table = behind_table.filter(|&end| end <= bytes.len());
        let behind_table =
            behind_table.ok_or_else(|| short(least.saturating_add(ENTRY.saturating_mul(count))))?;
        // All of it is measured and hashed before anything is read from it.
        let table = &bytes[HEADER..behind_table];
        let sizes = table.chunks_exact(ENTRY).map(bytes_of_class);
        let data = sizes.fold(0u64, u64::saturating_add);
        let fixed = (behind_table + size_of::<Hash>()) as u64;
        let expected = fixed.saturating_add(data);
        if expected != found {
            return Err(RayFileError::Length { expected, found });
        }
        sealed::check(bytes)
            .map_err(|sealed::Altered { found, stated }| RayFileError::Hash { found, stated })?;
        // Nothing is passed over: equal rays have equal bytes, and so one hash.
        for (at, expected) in [(48, RAYS_PER_CALL), (52, 0)] {
            let found = u32_at(header, at);
            if found != expected {
                return Err(RayFileError::Header { at, found, expected });
            }
        }
        let geometry = header[16..48].try_into().unwrap_or_default();
        let mut rest = &bytes[behind_table..];
        let mut file = Self { geometry, classes: Vec::new() };
        for (number, entry) in (1..).zip(table.chunks_exact(ENTRY)) {
            let own = read_class(number, entry, &mut rest)?;
            if file.class(own.class).is_some() {
                return Err(RayFileError::Twice { class: own.class.name() });
            }
            file.classes.push(own);
        }
        Ok(file)
    }
}

/// The numbers of a ray or a hit.
fn words(bytes: &[u8]) -> impl Iterator<Item = u32> {
    bytes.chunks_exact(4).map(|word| u32_at(word, 0))
}

/// The bytes of a class behind the table, by its entry there. What its query is not known for is counted as the smaller
/// of the two, and refused afterwards.
fn bytes_of_class(entry: &[u8]) -> u64 {
    let answer = if entry[1] == 0 { CLOSEST } else { ANY };
    u64_at(entry, 8).saturating_mul((RAY + answer) as u64)
}

/// Reads a class, and takes its bytes from `rest`, which has them.
fn read_class(number: usize, entry: &[u8], rest: &mut &[u8]) -> Result<ClassRays, RayFileError> {
    let unknown = |what, found| RayFileError::Unknown { number, what, found };
    let class = RayClass::ALL.get(usize::from(entry[0])).copied();
    let class = class.ok_or_else(|| unknown("class", entry[0].into()))?;
    let reserved = u64_at(entry, 0) >> 16;
    if reserved != 0 {
        return Err(unknown("meaning of its reserved bytes", reserved));
    }
    let query = entry[1];
    let size = match query {
        0 => CLOSEST,
        1 => ANY,
        other => return Err(unknown("query", other.into())),
    };
    // Both products are within the file's length, which was compared.
    let count = usize::try_from(u64_at(entry, 8)).unwrap_or(usize::MAX);
    let (own, behind) = rest.split_at(count * (RAY + size));
    let (ray_bytes, answer_bytes) = own.split_at(count * RAY);
    *rest = behind;
    let mut rays = Vec::with_capacity(count);
    for (index, bytes) in ray_bytes.chunks_exact(RAY).enumerate() {
        let ray = ray(bytes);
        ray.check().map_err(|error| RayFileError::Ray { class: class.name(), index, error })?;
        rays.push(ray);
    }
    let wrong = |index, why| RayFileError::Answer { class: class.name(), index, why };
    let answers = if query == 0 {
        let mut hits = Vec::with_capacity(count);
        for (index, bytes) in answer_bytes.chunks_exact(CLOSEST).enumerate() {
            let hit = hit(bytes);
            possible(&rays[index], &hit).map_err(|why| wrong(index, why))?;
            hits.push(hit);
        }
        RayAnswers::ClosestHit(hits)
    } else {
        let is_flag = |&byte: &u8| byte <= 1;
        if let Some(index) = answer_bytes.iter().position(|byte| !is_flag(byte)) {
            return Err(wrong(index, "it is neither 0 nor 1"));
        }
        RayAnswers::AnyHit(answer_bytes.iter().map(|&byte| byte == 1).collect())
    };
    Ok(ClassRays { class, rays, answers })
}

/// A ray from its bytes.
pub(super) fn ray(bytes: &[u8]) -> Ray {
    let mut numbers = words(bytes).map(f32::from_bits);
    let mut next = || numbers.next().unwrap_or_default();
    let mut vector = || Vec3::new(next(), next(), next());
    let origin = vector();
    let [t_min, x, y, z, t_max] = std::array::from_fn(|_| next());
    Ray { origin, t_min, dir: Vec3::new(x, y, z), t_max }
}

fn hit(bytes: &[u8]) -> Hit {
    let mut numbers = words(bytes);
    let mut next = || numbers.next().unwrap_or_default();
    Hit {
        t: f32::from_bits(next()),
        object: next(),
        prim: next(),
        u: f32::from_bits(next()),
        v: f32::from_bits(next()),
    }
}

/// Whether a ray can have a hit; if not, why.
fn possible(ray: &Ray, hit: &Hit) -> Result<(), &'static str> {
    if !hit.is_hit() {
        return if hit.same_bits(&Hit::MISS) {
            Ok(())
        } else {
            Err("it is no object, and no miss")
        };
    }
    if !(ray.t_min..=ray.end()).contains(&hit.t) {
        return Err("its t is outside of the ray's interval");
    }
    if !hit.u.is_finite() || !hit.v.is_finite() {
        return Err("its place on the surface is not finite");
    }
    Ok(())
}
